# Row of columns
# Draw again, in this folder: gnuplot row_of_columns.gp
set encoding utf8
set minussign
set title 'Row of columns'
set border 31 linewidth 1 linecolor rgb '#666666'
set tics nomirror scale 0.6 textcolor rgb 'black'
set style textbox opaque fillcolor rgb 'white' noborder margins 0.4,0.2
set size ratio -1
set key at screen 0.5,0.00720720720721 center bottom vertical maxcols 1 Left reverse samplen 2 width 1
set bmargin at screen 0.266666666667
set xrange [-3.8716250118:42.4672473435]
set xlabel 'distance from the toe (m)'
set xtics 10
set yrange [-2.48243959046:22.0568005025]
set ylabel 'height above the toe (m)'
set ytics 5
set label '4' at 2.71966948589,4.46921858974 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '6' at 4.66757503259,4.76466091564 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '8' at 6.61548057929,5.06010324155 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '10' at 8.56338612599,5.35554556745 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '12' at 10.5112916727,5.65098789335 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '14' at 12.4591972194,5.94643021926 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '16' at 14.4071027661,6.24187254516 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '18' at 16.3550083128,6.53731487106 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '20' at 18.3029138595,6.83275719697 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '22' at 20.2508194062,7.12819952287 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '24' at 22.1987249529,7.42364184877 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '26' at 24.1466304996,7.71908417468 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '28' at 26.0945360463,8.01452650058 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '30' at 28.042441593,8.30996882649 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '32' at 29.9903471397,8.60541115239 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '34' at 31.9382526864,8.90085347829 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '36' at 33.8861582331,9.1962958042 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '38' at 35.8340637798,9.4917381301 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '40' at 37.7819693265,9.787180456 center front offset character 0,0 textcolor rgb '#000000' font ',12' boxed
set label '1' at 0.64993293726,-0.806567609483 center front offset character 0,0 textcolor rgb '#000000' font ',15'
set label '2' at 1.64993293726,-0.806567609483 center front offset character 0,0 textcolor rgb '#000000' font ',15'
set label '3' at 2.64993293726,-0.806567609483 center front offset character 0,0 textcolor rgb '#000000' font ',15'
$series_1 << EOD
26 0
26.984807753 0.173648177667
24.2411665459 15.7336106753
23.2563587929 15.5599624976
EOD
$series_2 << EOD
27 0
27.984807753 0.173648177667
25.1890720926 16.0290530012
24.2042643396 15.8554048235
EOD
$series_3 << EOD
28 0
28.984807753 0.173648177667
26.1369776393 16.3244953271
25.1521698863 16.1508471494
EOD
$series_4 << EOD
29 0
29.984807753 0.173648177667
27.084883186 16.619937653
26.100075433 16.4462894753
EOD
$series_5 << EOD
30 0
30.984807753 0.173648177667
28.0327887327 16.9153799789
27.0479809797 16.7417318012
EOD
$series_6 << EOD
31 0
31.984807753 0.173648177667
28.9806942794 17.2108223048
27.9958865264 17.0371741271
EOD
$series_7 << EOD
32 0
32.984807753 0.173648177667
29.9285998261 17.5062646307
28.9437920731 17.332616453
EOD
$series_8 << EOD
33 0
33.984807753 0.173648177667
30.8765053728 17.8017069566
29.8916976198 17.6280587789
EOD
$series_9 << EOD
34 0
34.984807753 0.173648177667
31.8244109195 18.0971492825
30.8396031665 17.9235011048
EOD
$series_10 << EOD
35 0
35.984807753 0.173648177667
32.7723164662 18.3925916084
31.7875087132 18.2189434307
EOD
$series_11 << EOD
36 0
36.984807753 0.173648177667
33.7202220129 18.6880339343
32.7354142599 18.5143857566
EOD
$series_12 << EOD
37 0
37.984807753 0.173648177667
34.6681275596 18.9834762602
33.6833198066 18.8098280825
EOD
$series_13 << EOD
38 0
38.984807753 0.173648177667
35.6160331063 19.2789185861
34.6312253533 19.1052704084
EOD
$series_14 << EOD
39 0
39.984807753 0.173648177667
36.563938653 19.574360912
35.5791309 19.4007127343
EOD
$series_15 << EOD
3 0
3.98480775301 0.173648177667
2.43933897178 8.93843717948
1.45453121876 8.76478900181
EOD
$series_16 << EOD
4 0
4.98480775301 0.173648177667
3.38724451848 9.23387950538
2.40243676546 9.06023132771
EOD
$series_17 << EOD
5 0
5.98480775301 0.173648177667
4.33515006518 9.52932183128
3.35034231216 9.35567365362
EOD
$series_18 << EOD
6 0
6.98480775301 0.173648177667
5.28305561188 9.82476415719
4.29824785886 9.65111597952
EOD
$series_19 << EOD
7 0
7.98480775301 0.173648177667
6.23096115858 10.1202064831
5.24615340556 9.94655830542
EOD
$series_20 << EOD
8 0
8.98480775301 0.173648177667
7.17886670528 10.415648809
6.19405895226 10.2420006313
EOD
$series_21 << EOD
9 0
9.98480775301 0.173648177667
8.12677225198 10.7110911349
7.14196449896 10.5374429572
EOD
$series_22 << EOD
10 0
10.984807753 0.173648177667
9.07467779868 11.0065334608
8.08987004566 10.8328852831
EOD
$series_23 << EOD
11 0
11.984807753 0.173648177667
10.0225833454 11.3019757867
9.03777559236 11.128327609
EOD
$series_24 << EOD
12 0
12.984807753 0.173648177667
10.9704888921 11.5974181126
9.98568113906 11.4237699349
EOD
$series_25 << EOD
13 0
13.984807753 0.173648177667
11.9183944388 11.8928604385
10.9335866858 11.7192122608
EOD
$series_26 << EOD
14 0
14.984807753 0.173648177667
12.8662999855 12.1883027644
11.8814922325 12.0146545867
EOD
$series_27 << EOD
15 0
15.984807753 0.173648177667
13.8142055322 12.4837450903
12.8293977792 12.3100969127
EOD
$series_28 << EOD
16 0
16.984807753 0.173648177667
14.7621110789 12.7791874162
13.7773033259 12.6055392386
EOD
$series_29 << EOD
17 0
17.984807753 0.173648177667
15.7100166256 13.0746297421
14.7252088726 12.9009815645
EOD
$series_30 << EOD
18 0
18.984807753 0.173648177667
16.6579221723 13.370072068
15.6731144193 13.1964238904
EOD
$series_31 << EOD
19 0
19.984807753 0.173648177667
17.605827719 13.6655143939
16.621019966 13.4918662163
EOD
$series_32 << EOD
20 0
20.984807753 0.173648177667
18.5537332657 13.9609567198
17.5689255127 13.7873085422
EOD
$series_33 << EOD
21 0
21.984807753 0.173648177667
19.5016388124 14.2563990457
18.5168310594 14.0827508681
EOD
$series_34 << EOD
22 0
22.984807753 0.173648177667
20.4495443591 14.5518413716
19.4647366061 14.378193194
EOD
$series_35 << EOD
23 0
23.984807753 0.173648177667
21.3974499058 14.8472836975
20.4126421528 14.6736355199
EOD
$series_36 << EOD
24 0
24.984807753 0.173648177667
22.3453554525 15.1427260235
21.3605476995 14.9690778458
EOD
$series_37 << EOD
25 0
25.984807753 0.173648177667
23.2932609992 15.4381683494
22.3084532462 15.2645201717
EOD
$series_38 << EOD
0 0
0.984807753012 0.173648177667
-0.404377668323 8.05211020176
-1.38918542134 7.8784620241
EOD
$series_39 << EOD
1 0
1.98480775301 0.173648177667
0.543527878377 8.34755252767
-0.441279874636 8.17390435
EOD
$series_40 << EOD
2 0
2.98480775301 0.173648177667
1.49143342508 8.64299485357
0.506625672064 8.4693466759
EOD
$series_41 << EOD
0 0
0.984807753012 0.173648177667
-0.404377668323 8.05211020176
-1.38918542134 7.8784620241
0 0
nan nan
1 0
1.98480775301 0.173648177667
0.543527878377 8.34755252767
-0.441279874636 8.17390435
1 0
nan nan
2 0
2.98480775301 0.173648177667
1.49143342508 8.64299485357
0.506625672064 8.4693466759
2 0
nan nan
3 0
3.98480775301 0.173648177667
2.43933897178 8.93843717948
1.45453121876 8.76478900181
3 0
nan nan
4 0
4.98480775301 0.173648177667
3.38724451848 9.23387950538
2.40243676546 9.06023132771
4 0
nan nan
5 0
5.98480775301 0.173648177667
4.33515006518 9.52932183128
3.35034231216 9.35567365362
5 0
nan nan
6 0
6.98480775301 0.173648177667
5.28305561188 9.82476415719
4.29824785886 9.65111597952
6 0
nan nan
7 0
7.98480775301 0.173648177667
6.23096115858 10.1202064831
5.24615340556 9.94655830542
7 0
nan nan
8 0
8.98480775301 0.173648177667
7.17886670528 10.415648809
6.19405895226 10.2420006313
8 0
nan nan
9 0
9.98480775301 0.173648177667
8.12677225198 10.7110911349
7.14196449896 10.5374429572
9 0
nan nan
10 0
10.984807753 0.173648177667
9.07467779868 11.0065334608
8.08987004566 10.8328852831
10 0
nan nan
11 0
11.984807753 0.173648177667
10.0225833454 11.3019757867
9.03777559236 11.128327609
11 0
nan nan
12 0
12.984807753 0.173648177667
10.9704888921 11.5974181126
9.98568113906 11.4237699349
12 0
nan nan
13 0
13.984807753 0.173648177667
11.9183944388 11.8928604385
10.9335866858 11.7192122608
13 0
nan nan
14 0
14.984807753 0.173648177667
12.8662999855 12.1883027644
11.8814922325 12.0146545867
14 0
nan nan
15 0
15.984807753 0.173648177667
13.8142055322 12.4837450903
12.8293977792 12.3100969127
15 0
nan nan
16 0
16.984807753 0.173648177667
14.7621110789 12.7791874162
13.7773033259 12.6055392386
16 0
nan nan
17 0
17.984807753 0.173648177667
15.7100166256 13.0746297421
14.7252088726 12.9009815645
17 0
nan nan
18 0
18.984807753 0.173648177667
16.6579221723 13.370072068
15.6731144193 13.1964238904
18 0
nan nan
19 0
19.984807753 0.173648177667
17.605827719 13.6655143939
16.621019966 13.4918662163
19 0
nan nan
20 0
20.984807753 0.173648177667
18.5537332657 13.9609567198
17.5689255127 13.7873085422
20 0
nan nan
21 0
21.984807753 0.173648177667
19.5016388124 14.2563990457
18.5168310594 14.0827508681
21 0
nan nan
22 0
22.984807753 0.173648177667
20.4495443591 14.5518413716
19.4647366061 14.378193194
22 0
nan nan
23 0
23.984807753 0.173648177667
21.3974499058 14.8472836975
20.4126421528 14.6736355199
23 0
nan nan
24 0
24.984807753 0.173648177667
22.3453554525 15.1427260235
21.3605476995 14.9690778458
24 0
nan nan
25 0
25.984807753 0.173648177667
23.2932609992 15.4381683494
22.3084532462 15.2645201717
25 0
nan nan
26 0
26.984807753 0.173648177667
24.2411665459 15.7336106753
23.2563587929 15.5599624976
26 0
nan nan
27 0
27.984807753 0.173648177667
25.1890720926 16.0290530012
24.2042643396 15.8554048235
27 0
nan nan
28 0
28.984807753 0.173648177667
26.1369776393 16.3244953271
25.1521698863 16.1508471494
28 0
nan nan
29 0
29.984807753 0.173648177667
27.084883186 16.619937653
26.100075433 16.4462894753
29 0
nan nan
30 0
30.984807753 0.173648177667
28.0327887327 16.9153799789
27.0479809797 16.7417318012
30 0
nan nan
31 0
31.984807753 0.173648177667
28.9806942794 17.2108223048
27.9958865264 17.0371741271
31 0
nan nan
32 0
32.984807753 0.173648177667
29.9285998261 17.5062646307
28.9437920731 17.332616453
32 0
nan nan
33 0
33.984807753 0.173648177667
30.8765053728 17.8017069566
29.8916976198 17.6280587789
33 0
nan nan
34 0
34.984807753 0.173648177667
31.8244109195 18.0971492825
30.8396031665 17.9235011048
34 0
nan nan
35 0
35.984807753 0.173648177667
32.7723164662 18.3925916084
31.7875087132 18.2189434307
35 0
nan nan
36 0
36.984807753 0.173648177667
33.7202220129 18.6880339343
32.7354142599 18.5143857566
36 0
nan nan
37 0
37.984807753 0.173648177667
34.6681275596 18.9834762602
33.6833198066 18.8098280825
37 0
nan nan
38 0
38.984807753 0.173648177667
35.6160331063 19.2789185861
34.6312253533 19.1052704084
38 0
nan nan
39 0
39.984807753 0.173648177667
36.563938653 19.574360912
35.5791309 19.4007127343
39 0
nan nan
EOD
set terminal svg size 720,555 dynamic noenhanced font 'sans-serif,19' background rgb 'white'
set output 'row_of_columns.svg'
marker = 0.6
set key spacing 0.92
plot $series_1 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_2 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_3 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_4 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_5 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_6 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_7 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_8 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_9 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_10 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_11 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_12 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_13 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_14 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.3 noborder notitle, \
     $series_15 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder title 'slides and topples', \
     $series_16 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_17 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_18 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_19 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_20 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_21 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_22 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_23 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_24 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_25 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_26 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_27 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_28 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_29 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_30 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_31 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_32 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_33 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_34 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_35 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_36 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_37 using 1:2 with filledcurves closed fillcolor rgb '#CC79A7' fillstyle transparent solid 0.6 noborder notitle, \
     $series_38 using 1:2 with filledcurves closed fillcolor rgb '#666666' fillstyle transparent solid 0.6 noborder title 'fixed', \
     $series_39 using 1:2 with filledcurves closed fillcolor rgb '#666666' fillstyle transparent solid 0.6 noborder notitle, \
     $series_40 using 1:2 with filledcurves closed fillcolor rgb '#666666' fillstyle transparent solid 0.6 noborder notitle, \
     $series_41 using 1:2 with lines linewidth 1.2 dashtype solid linecolor rgb '#000000' notitle
set terminal pngcairo size 1440,1110 noenhanced font 'sans,19' fontscale 1.5 linewidth 2 pointscale 2 background rgb 'white'
set output 'row_of_columns.png'
marker = 1
set key spacing 1.1
replot
set output
