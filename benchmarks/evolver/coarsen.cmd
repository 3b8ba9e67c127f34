// SPDX-License-Identifier: GPL-3.0-or-later
// Surface Evolver commands that coarsen a foam in equilibrium by von Neumann's law for nstep steps.
// von Neumann coarsening: dA/dt = K (n-6), T1 guarded, T2 via "delete" of two edges
suppress_warning 1055
suppress_warning 1825
quiet on
define vertex attribute xs real[2]
nrest := 0; lastt2 := 0; wasq := 1; nbad := 0;
nt1 := 0; nt2 := 0; ng := 0; nh := 0; dt1 := 0; de := 0; eold := 0; conv := 0; kk := 0; lc := 0.1; kdt := 0.01;
nclamp := 0; defect := 0; nforced := 0; nside_min := 3; a2 := 0.05; a3 := 0.03; npop := 0; afloor := 0.02; found := 0; fid := 0; bid := 0; tt := 0; istep := 0; nstep := 50; ts := 0; thist1 := 0; emin := 0; lmin := 0; nfail := 0;
dot1 := { reset_counts;
  set facet ff nside sum(ff.edge,1);
  foreach edge ee where length < lc do {
    if min(ee.facet ff, ff.nside) > 3 then { t1_edgeswap ee; foreach ee.vertex vv do foreach vv.facet ff do ff.nside := sum(ff.edge,1); };
  };
  dt1 := t1_edgeswap_count; nt1 += dt1; }
grow := { set facet ff nside sum(ff.edge,1);
  foreach facet ff do { bid := ff.id; tt := body[bid].target + kdt*(ff.nside-6); if tt < afloor then { nclamp += 1; defect += tt - afloor; tt := afloor; }; body[bid].target := tt; };
  if defect != 0 then { tt := defect/facet_count; defect := 0; set body bb target bb.target + tt; };
}
dot2 := { found := 1;
  while found do { found := 0; fid := 0;
    set facet ff nside sum(ff.edge,1);
    foreach facet ff do { if (((ff.nside <= 3) and (body[ff.id].target < a2)) or ((ff.nside <= 5) and (body[ff.id].target < a3))) then { fid := ff.id; found := 1; break; } };
    if found then {
      bid := fid; tt := body[bid].target/facet[fid].nside;
      foreach facet[fid].edge ee do foreach ee.facet ff do { if ff.id != fid then body[ff.id].target += tt; };
      body[bid].target := 0;
      while valid_element(facet[fid]) do delete facet[fid].edge[1];
      dissolve body[bid];
      nt2 += 1;
      linear; if max(vertex,valence) > 3 then { pop vertex where valence > 3; npop += 1; };
      g 10; quadratic; ng += 10;
    };
  };
}
relax := { conv := 0; kk := 0; g 5; ng += 5;
  if nt2 > lastt2 then { lastt2 := nt2; };
  while ( (conv == 0) and (kk < 25) ) do {
    kk += 1; eold := total_energy; dt1 := 0;
    if min(edge,length) < lc then { linear; dot1; g 10; quadratic; g 5; ng += 15; };
    if (dt1 == 0) then { if min(edge,length) < 0.12 then { g 10; ng += 10; de := eold - total_energy; if ( abs(de) < 1e-6*total_energy ) then conv := 1; } 
           else { hessian_seek; nh += 1; de := eold - total_energy; if ( abs(de) < 1e-9*total_energy ) then conv := 1; }; };
  };
  if conv == 0 then nfail += 1;
}
step := { grow; dot2; relax; istep += 1; 
  printf "step %d pop %d cells %d E %.8f T1 %d T2 %d forced %d hk %d conv %d minL %g minA %g maxdA %.2g t %.3f\n",istep,npop,facet_count,total_energy,nt1,nt2,nforced,kk,conv,min(edge,length),min(body,volume),max(body,abs(volume-target)),clock-ts; }
ts := clock
while istep < nstep do step
printf "COARSEN END cells %d T1 %d T2 %d forced %d clamp %d ng %d nh %d nonconv %d restored %d t %.3f per step %.4f\n",facet_count,nt1,nt2,nforced,nclamp,ng,nh,nfail,nrest,clock-ts,(clock-ts)/nstep
quit
