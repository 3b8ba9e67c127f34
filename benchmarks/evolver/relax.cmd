// SPDX-License-Identifier: GPL-3.0-or-later
// Surface Evolver commands that bring a periodic foam to equilibrium: T1s on edges shorter than lc and
// gradient steps on straight edges, then on arcs, then Newton steps until the energy stands still.
nt1 := 0; ng := 0; nh := 0; npass := 0; conv := 0; kk := 0; dt1 := 0; thist1 := 0; de := 0; gper := 20; maxpass := 60; etol := 1e-6;
lc := 0.1;
tstart := clock;
eold := 1e30; nsmall := 0;
define facet attribute nside integer
// T1 guarded: never on an edge of a 3-sided cell (would make a 2-sided cell)
dot1 := { reset_counts;
  set facet ff nside sum(ff.edge,1);
  foreach edge ee where length < lc do {
    if min(ee.facet ff, ff.nside) > 3 then { t1_edgeswap ee; foreach ee.vertex vv do foreach vv.facet ff do ff.nside := sum(ff.edge,1); };
  };
  dt1 := t1_edgeswap_count; nt1 += dt1; }
phase1 := {
  conv := 0; npass := 0; eold := 1e30;
  while ( (conv == 0) and (npass < maxpass) ) do {
    dot1; thist1 := dt1;
    g gper; ng += gper;
    npass += 1;
    de := eold - total_energy; eold := total_energy;
    printf "pass %d E %.10f dE %.3g T1 %d minL %g maxdA %.3g t %.2f\n",npass,total_energy,de,thist1,min(edge,length),max(body,abs(volume-target)),clock-tstart;
    if ( (thist1 == 0) and (de < etol*total_energy) and (de > -1e-6) ) then conv := 1;
  }
}
phase2 := {
  conv := 0; kk := 0; eold := total_energy;
  while ( (conv == 0) and (kk < 40) ) do {
    dot1; thist1 := dt1; 
    if thist1 > 0 then { g 20; ng += 20; };
    hessian_seek; nh += 1; kk += 1;
    de := eold - total_energy; eold := total_energy;
    printf "hess %d E %.12f dE %.3g T1 %d minL %g maxdA %.3g t %.2f\n",kk,total_energy,de,thist1,min(edge,length),max(body,abs(volume-target)),clock-tstart;
    if ( (thist1 == 0) and (abs(de) < 1e-12*total_energy) ) then conv := 1;
  }
}
suppress_warning 1055
suppress_warning 1825
quiet on
etol := 1e-3
phase1
M 2
maxpass := 10
phase1
phase2
printf "FINAL E %.12f nt1 %d nh %d maxdA %.3g cpu %.4f\n",total_energy,nt1,nh,max(body,abs(volume-target)),clock-tstart;
