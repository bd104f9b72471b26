!> The catalogue of pipe within the program: input/catalogue.csv without its comments, for an installed program in any folder.
!> Written by .ci/embed_catalogue.py --write. Change the table, not this file.
module dg_catalogue_lines
   implicit none
   private
   public :: catalogue_lines

   character(*), parameter :: catalogue_lines(155) = [character(151) :: &
      'name,kind,od_in,id_in,mass_lbm_ft,joint_od_in,joint_length_ft,joint_spacing_ft,yield_ksi,source,connection,joi'// &
      'nt_id_in,density_kg_m3,youngs_GPa,poisson', &
      'DP 2-3/8 6.65 NC26,drillpipe,2.375,1.815,6.94,3.375,1.25,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 2-7/8 10.40 NC31,drillpipe,2.875,2.151,10.78,4.125,1.333,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 3-1/2 13.30 NC38,drillpipe,3.5,2.764,13.8,4.75,1.542,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 3-1/2 15.50 NC38,drillpipe,3.5,2.602,16.43,5,1.542,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 4 14.00 NC40,drillpipe,4,3.34,14.82,5.25,1.417,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 4 15.70 NC40,drillpipe,4,3.24,16.58,5.25,1.417,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 4-1/2 16.60 NC46,drillpipe,4.5,3.826,17.89,6.25,1.417,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 4-1/2 16.60 NC50,drillpipe,4.5,3.826,18.06,6.625,1.417,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 4-1/2 20.00 NC46,drillpipe,4.5,3.64,21.62,6.25,1.417,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 4-1/2 20.00 NC50,drillpipe,4.5,3.64,21.71,6.625,1.417,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 5 19.50 NC50,drillpipe,5,4.276,20.87,6.625,1.417,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 5 19.50 5-1/2 FH,drillpipe,5,4.276,21.72,7,1.5,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 5 25.60 5-1/2 FH,drillpipe,5,4,27.76,7,1.5,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 5-1/2 21.90 FH,drillpipe,5.5,4.778,23.25,7,1.5,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 5-1/2 24.70 FH,drillpipe,5.5,4.67,25.84,7,1.5,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 5-7/8 23.40 XT57,drillpipe,5.875,5.153,25.55,7,2.083,30,,makers'' common dimensions; mass by rule 1,,,,,', &
      'DP 5-7/8 26.30 XT57,drillpipe,5.875,5.045,28.29,7,2.083,30,,makers'' common dimensions; mass by rule 1,,,,,', &
      'DP 6-5/8 25.20 FH,drillpipe,6.625,5.965,26.54,8,1.583,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 6-5/8 27.70 FH,drillpipe,6.625,5.901,28.46,8,1.583,30,,API Spec 5D and 7-2; mass by rule 1,,,,,', &
      'DP 2-3/8 6.65 NC26 3-3/8x1-3/4,drillpipe,2.375,1.815,6.94,3.375,1.25,30,,API Spec 5D and 7-2; mass by rule 1,N'// &
      'C26,1.75,,,', &
      'DP 2-7/8 10.40 NC31 4-1/8x2-1/8,drillpipe,2.875,2.151,10.78,4.125,1.333,30,,API Spec 5D and 7-2; mass by rule '// &
      '1,NC31,2.125,,,', &
      'DP 3-1/2 13.30 NC38 4-3/4x2-11/16,drillpipe,3.5,2.764,13.8,4.75,1.542,30,,API Spec 5D and 7-2; mass by rule 1,'// &
      'NC38,2.6875,,,', &
      'DP 3-1/2 13.30 NC38 5x2-1/8,drillpipe,3.5,2.764,14.5,5,1.542,30,,API Spec 5D and 7-2; mass by rule 1,NC38,2.12'// &
      '5,,,', &
      'DP 4 14.00 NC40 5-1/4x2-13/16,drillpipe,4,3.34,14.82,5.25,1.417,30,,API Spec 5D and 7-2; mass by rule 1,NC40,2'// &
      '.8125,,,', &
      'DP 4-1/2 16.60 NC46 6-1/4x3,drillpipe,4.5,3.826,18.09,6.25,1.417,30,,API Spec 5D and 7-2; mass by rule 1,NC46,'// &
      '3,,,', &
      'DP 5 19.50 NC50 6-3/8x3-3/4,drillpipe,5,4.276,20.46,6.375,1.417,30,,API Spec 5D and 7-2; mass by rule 1,NC50,3'// &
      '.75,,,', &
      'DP 5 19.50 NC50 6-3/8x3-1/2,drillpipe,5,4.276,20.69,6.375,1.417,30,,API Spec 5D and 7-2; mass by rule 1,NC50,3'// &
      '.5,,,', &
      'DP 5 19.50 NC50 6-1/2x3-1/4,drillpipe,5,4.276,21.1,6.5,1.417,30,,API Spec 5D and 7-2; mass by rule 1,NC50,3.25'// &
      ',,,', &
      'DP 5 19.50 NC50 6-5/8x2-3/4,drillpipe,5,4.276,21.69,6.625,1.417,30,,API Spec 5D and 7-2; mass by rule 1,NC50,2'// &
      '.75,,,', &
      'DP 5-1/2 21.90 5-1/2FH 7x4,drillpipe,5.5,4.778,23.25,7,1.5,30,,API Spec 5D and 7-2; mass by rule 1,5-1/2FH,4,,'// &
      ',', &
      'DP 5-1/2 21.90 5-1/2FH 7-1/4x3-1/2,drillpipe,5.5,4.778,24.23,7.25,1.5,30,,API Spec 5D and 7-2; mass by rule 1,'// &
      '5-1/2FH,3.5,,,', &
      'DP 5-1/2 21.90 5-1/2FH 7-1/2x3,drillpipe,5.5,4.778,25.16,7.5,1.5,30,,API Spec 5D and 7-2; mass by rule 1,5-1/2'// &
      'FH,3,,,', &
      'DP 6-5/8 25.20 6-5/8FH 8x5,drillpipe,6.625,5.965,26.54,8,1.583,30,,API Spec 5D and 7-2; mass by rule 1,6-5/8FH'// &
      ',5,,,', &
      'DP 6-5/8 25.20 6-5/8FH 8-1/2x4-1/4,drillpipe,6.625,5.965,28.68,8.5,1.583,30,,API Spec 5D and 7-2; mass by rule'// &
      ' 1,6-5/8FH,4.25,,,', &
      'ADP 114x10,aluminium_pipe,4.4882,3.7008,7.55,5.5118,1.476,39.37,,ISO 15546 and GOST 23786; mass by rule 4,,,32'// &
      '44,71,0.33', &
      'ADP 129x11,aluminium_pipe,5.0787,4.2126,9.14,5.9843,1.476,39.37,,ISO 15546 and GOST 23786; mass by rule 4,,,31'// &
      '88,71,0.33', &
      'ADP 147x11,aluminium_pipe,5.7874,4.9213,10.62,6.7717,1.476,39.37,,ISO 15546 and GOST 23786; mass by rule 4,,,3'// &
      '202,71,0.33', &
      'ADP 147x13,aluminium_pipe,5.7874,4.7638,12.16,6.7717,1.476,39.37,,ISO 15546 and GOST 23786; mass by rule 4,,,3'// &
      '171,71,0.33', &
      'ADP 170x11,aluminium_pipe,6.6929,5.8268,12.51,7.7559,1.476,39.37,,ISO 15546 and GOST 23786; mass by rule 4,,,3'// &
      '216,71,0.33', &
      'HWDP 3-1/2 25.3,hwdp,3.5,2.0625,25.3,4.75,4,30,55,makers'' common dimensions; mass as named,,,,,', &
      'HWDP 4 29.7,hwdp,4,2.5625,29.7,5.25,4,30,55,makers'' common dimensions; mass as named,,,,,', &
      'HWDP 4-1/2 41.0,hwdp,4.5,2.75,41,6.25,4,30,55,makers'' common dimensions; mass as named,,,,,', &
      'HWDP 5 49.3,hwdp,5,3,49.3,6.5,4,30,55,makers'' common dimensions; mass as named,,,,,', &
      'HWDP 5-1/2 57.0,hwdp,5.5,3.375,57,7,4,30,55,makers'' common dimensions; mass as named,,,,,', &
      'HWDP 6-5/8 70.8,hwdp,6.625,4.5,70.8,8,4,30,55,makers'' common dimensions; mass as named,,,,,', &
      'DC 3-1/8 1-1/4 NC23,collar,3.125,1.25,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 3-1/2 1-1/2 NC26,collar,3.5,1.5,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 4-1/8 2 NC31,collar,4.125,2,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 4-3/4 2 NC35,collar,4.75,2,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 5 2-1/4 NC38,collar,5,2.25,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 6 2-1/4 NC44,collar,6,2.25,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 6-1/4 2-13/16 NC46,collar,6.25,2.8125,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 6-1/2 2-13/16 NC46,collar,6.5,2.8125,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 6-3/4 2-1/4 NC46,collar,6.75,2.25,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 6-3/4 2-13/16 NC50,collar,6.75,2.8125,,,,,110,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 7 2-13/16 NC50,collar,7,2.8125,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 7-1/4 2-13/16 NC50,collar,7.25,2.8125,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 7-3/4 2-13/16 NC56,collar,7.75,2.8125,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 8 2-13/16 NC56,collar,8,2.8125,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 8-1/4 2-13/16 6-5/8 REG,collar,8.25,2.8125,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 9 2-13/16 NC61,collar,9,2.8125,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 9-1/2 3 7-5/8 REG,collar,9.5,3,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'DC 11 3 8-5/8 REG,collar,11,3,,,,,100,API Spec 7-1; mass by rule 2,,,,,', &
      'STAB 6,stabilizer,4.75,2,,5.96875,,,,blades 1/32 in under the hole; mass by rule 2 without blades,,,,,', &
      'STAB 6 1/8 under,stabilizer,4.75,2,,5.875,,,,blades 1/8 in under the hole; mass by rule 2 without blades,,,,,', &
      'STAB 8-1/2,stabilizer,6.75,2.8125,,8.46875,,,,blades 1/32 in under the hole; mass by rule 2 without blades,,,,'// &
      ',', &
      'STAB 8-1/2 1/8 under,stabilizer,6.75,2.8125,,8.375,,,,blades 1/8 in under the hole; mass by rule 2 without bla'// &
      'des,,,,,', &
      'STAB 12-1/4,stabilizer,8,2.8125,,12.2188,,,,blades 1/32 in under the hole; mass by rule 2 without blades,,,,,', &
      'STAB 12-1/4 1/8 under,stabilizer,8,2.8125,,12.125,,,,blades 1/8 in under the hole; mass by rule 2 without blad'// &
      'es,,,,,', &
      'STAB 17-1/2,stabilizer,9.5,3,,17.4688,,,,blades 1/32 in under the hole; mass by rule 2 without blades,,,,,', &
      'STAB 17-1/2 1/8 under,stabilizer,9.5,3,,17.375,,,,blades 1/8 in under the hole; mass by rule 2 without blades,'// &
      ',,,,', &
      'MOTOR 3-3/4,motor,3.75,1.875,,,,,,mass by rule 3; a stand-in for the maker''s numbers,,,,,', &
      'MOTOR 4-3/4,motor,4.75,2.375,,,,,,mass by rule 3; a stand-in for the maker''s numbers,,,,,', &
      'MOTOR 6-3/4,motor,6.75,3.375,,,,,,mass by rule 3; a stand-in for the maker''s numbers,,,,,', &
      'MOTOR 8,motor,8,4,,,,,,mass by rule 3; a stand-in for the maker''s numbers,,,,,', &
      'MOTOR 9-5/8,motor,9.625,4.8125,,,,,,mass by rule 3; a stand-in for the maker''s numbers,,,,,', &
      'CSG 4-1/2 11.60,casing,4.5,4,11.6,5,0.74,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 4-1/2 13.50,casing,4.5,3.92,13.5,5,0.74,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 5 15.00,casing,5,4.408,15,5.563,0.76,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 5 18.00,casing,5,4.276,18,5.563,0.76,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 5-1/2 15.50,casing,5.5,4.95,15.5,6.05,0.771,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 5-1/2 17.00,casing,5.5,4.892,17,6.05,0.771,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 5-1/2 20.00,casing,5.5,4.778,20,6.05,0.771,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 5-1/2 23.00,casing,5.5,4.67,23,6.05,0.771,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7 23.00,casing,7,6.366,23,7.656,0.833,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7 26.00,casing,7,6.276,26,7.656,0.833,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7 29.00,casing,7,6.184,29,7.656,0.833,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7 32.00,casing,7,6.094,32,7.656,0.833,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7 35.00,casing,7,6.004,35,7.656,0.833,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7 38.00,casing,7,5.92,38,7.656,0.833,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7-5/8 26.40,casing,7.625,6.969,26.4,8.5,0.865,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7-5/8 29.70,casing,7.625,6.875,29.7,8.5,0.865,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7-5/8 33.70,casing,7.625,6.765,33.7,8.5,0.865,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 7-5/8 39.00,casing,7.625,6.625,39,8.5,0.865,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 8-5/8 32.00,casing,8.625,7.921,32,9.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 8-5/8 36.00,casing,8.625,7.825,36,9.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 9-5/8 36.00,casing,9.625,8.921,36,10.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 9-5/8 40.00,casing,9.625,8.835,40,10.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 9-5/8 43.50,casing,9.625,8.755,43.5,10.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 9-5/8 47.00,casing,9.625,8.681,47,10.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 9-5/8 53.50,casing,9.625,8.535,53.5,10.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 9-5/8 58.40,casing,9.625,8.435,58.4,10.625,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 10-3/4 45.50,casing,10.75,9.95,45.5,11.75,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 10-3/4 51.00,casing,10.75,9.85,51,11.75,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 10-3/4 55.50,casing,10.75,9.76,55.5,11.75,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 11-3/4 60.00,casing,11.75,10.772,60,12.75,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 13-3/8 54.50,casing,13.375,12.615,54.5,14.375,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,'// &
      ',', &
      'CSG 13-3/8 61.00,casing,13.375,12.515,61,14.375,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 13-3/8 68.00,casing,13.375,12.415,68,14.375,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 13-3/8 72.00,casing,13.375,12.347,72,14.375,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 16 75.00,casing,16,15.124,75,17,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 16 84.00,casing,16,15.01,84,17,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 18-5/8 87.50,casing,18.625,17.755,87.5,20,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 20 94.00,casing,20,19.124,94,21,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'CSG 20 133.00,casing,20,18.73,133,21,0.885,40,,API Spec 5CT; buttress coupling; mass as named,,,,,', &
      'TBG 2-3/8 4.70 EUE,tubing,2.375,1.995,4.7,3.063,0.406,31,,API Spec 5CT; mass as named,,,,,', &
      'TBG 2-3/8 5.95 EUE,tubing,2.375,1.867,5.95,3.063,0.406,31,,API Spec 5CT; mass as named,,,,,', &
      'TBG 2-7/8 6.50 EUE,tubing,2.875,2.441,6.5,3.668,0.438,31,,API Spec 5CT; mass as named,,,,,', &
      'TBG 2-7/8 8.70 EUE,tubing,2.875,2.259,8.7,3.668,0.438,31,,API Spec 5CT; mass as named,,,,,', &
      'TBG 3-1/2 9.30 EUE,tubing,3.5,2.992,9.3,4.5,0.479,31,,API Spec 5CT; mass as named,,,,,', &
      'TBG 3-1/2 12.95 EUE,tubing,3.5,2.75,12.95,4.5,0.479,31,,API Spec 5CT; mass as named,,,,,', &
      'TBG 4 11.00 EUE,tubing,4,3.476,11,5,0.5,31,,API Spec 5CT; mass as named,,,,,', &
      'TBG 4-1/2 12.75 EUE,tubing,4.5,3.958,12.75,5.563,0.521,31,,API Spec 5CT; mass as named,,,,,', &
      'ROD 5/8,sucker_rod,0.625,0,1.135,1.5,0.333,25,,API Spec 11B; mass of API RP 11L; full-size coupling,,,,,', &
      'ROD 5/8 SH,sucker_rod,0.625,0,1.135,1.25,0.333,25,,API Spec 11B; mass of API RP 11L; slim-hole coupling,,,,,', &
      'ROD 3/4,sucker_rod,0.75,0,1.634,1.625,0.333,25,,API Spec 11B; mass of API RP 11L; full-size coupling,,,,,', &
      'ROD 3/4 SH,sucker_rod,0.75,0,1.634,1.5,0.333,25,,API Spec 11B; mass of API RP 11L; slim-hole coupling,,,,,', &
      'ROD 7/8,sucker_rod,0.875,0,2.224,1.8125,0.333,25,,API Spec 11B; mass of API RP 11L; full-size coupling,,,,,', &
      'ROD 7/8 SH,sucker_rod,0.875,0,2.224,1.625,0.333,25,,API Spec 11B; mass of API RP 11L; slim-hole coupling,,,,,', &
      'ROD 1,sucker_rod,1,0,2.904,2.1875,0.333,25,,API Spec 11B; mass of API RP 11L; full-size coupling,,,,,', &
      'ROD 1 SH,sucker_rod,1,0,2.904,2,0.333,25,,API Spec 11B; mass of API RP 11L; slim-hole coupling,,,,,', &
      'ROD 1-1/8,sucker_rod,1.125,0,3.676,2.375,0.333,25,,API Spec 11B; mass of API RP 11L; full-size coupling,,,,,', &
      'ROD 1-1/8 SH,sucker_rod,1.125,0,3.676,2.25,0.333,25,,API Spec 11B; mass of API RP 11L; slim-hole coupling,,,,,', &
      'E75,grade,,,,,,,75,API Spec 5D; least yield strength,,,,,', &
      'X95,grade,,,,,,,95,API Spec 5D; least yield strength,,,,,', &
      'G105,grade,,,,,,,105,API Spec 5D; least yield strength,,,,,', &
      'S135,grade,,,,,,,135,API Spec 5D; least yield strength,,,,,', &
      'D16T,grade,,,,,,,47.137,ISO 15546 group I; least yield strength (325 MPa),,,,,', &
      '1953T1,grade,,,,,,,69.618,ISO 15546 group II; least yield strength (480 MPa),,,,,', &
      'H40,grade,,,,,,,40,API Spec 5CT; least yield strength,,,,,', &
      'J55,grade,,,,,,,55,API Spec 5CT; least yield strength,,,,,', &
      'K55,grade,,,,,,,55,API Spec 5CT; least yield strength,,,,,', &
      'M65,grade,,,,,,,65,API Spec 5CT; least yield strength,,,,,', &
      'N80,grade,,,,,,,80,API Spec 5CT; least yield strength,,,,,', &
      'L80,grade,,,,,,,80,API Spec 5CT; least yield strength,,,,,', &
      'C90,grade,,,,,,,90,API Spec 5CT; least yield strength,,,,,', &
      'R95,grade,,,,,,,95,API Spec 5CT; least yield strength,,,,,', &
      'T95,grade,,,,,,,95,API Spec 5CT; least yield strength,,,,,', &
      'C110,grade,,,,,,,110,API Spec 5CT; least yield strength,,,,,', &
      'P110,grade,,,,,,,110,API Spec 5CT; least yield strength,,,,,', &
      'Q125,grade,,,,,,,125,API Spec 5CT; least yield strength,,,,,', &
      'ROD-K,grade,,,,,,,60,API Spec 11B; least yield strength,,,,,', &
      'ROD-C,grade,,,,,,,60,API Spec 11B; least yield strength,,,,,', &
      'ROD-D,grade,,,,,,,85,API Spec 11B; least yield strength,,,,,']
end module dg_catalogue_lines
