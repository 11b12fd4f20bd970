# Forces that each block passes on to the one below
# Draw again, in this folder: gnuplot goodman_bray_forces.gp
set encoding utf8
set minussign
set title 'Forces that each block passes on to the one below'
set border 31 linewidth 1 linecolor rgb '#666666'
set tics nomirror scale 0.6 textcolor rgb 'black'
set style textbox opaque fillcolor rgb 'white' noborder margins 0.4,0.2
set key at screen 0.5,0.0062015503876 center bottom vertical maxcols 1 Left reverse samplen 2 width 1
set bmargin at screen 0.435658914729
set xrange [0.5:16.5]
set xlabel 'number of the block'
set xtics ('1' 1, '2' 2, '3' 3, '4' 4, '5' 5, '6' 6, '7' 7, '8' 8, '9' 9, '10' 10, '11' 11, '12' 12, '13' 13, '14' 14, '15' 15, '16' 16)
set yrange [-3735.90363378:5397.85646605]
set ylabel 'interblock force (kN/m)'
set grid ytics linetype 1 linewidth 0.5 linecolor rgb '#D8D8D8'
set ytics 2000
$series_1 << EOD
13.5 -3735.90363378
16.5 -3735.90363378
16.5 5397.85646605
13.5 5397.85646605
EOD
$series_2 << EOD
0.5 -3735.90363378
3.5 -3735.90363378
3.5 5397.85646605
0.5 5397.85646605
EOD
$series_3 << EOD
3.5 -3735.90363378
13.5 -3735.90363378
13.5 5397.85646605
3.5 5397.85646605
EOD
$series_4 << EOD
0.5 0
16.5 0
EOD
$series_5 << EOD
1 1.54178119618
2 472.214833602
3 1413.56093841
4 2825.58009563
5 3978.13248958
6 4637.51522753
7 4837.01154763
8 4594.79546925
9 3922.15754074
10 2826.7197347
11 1555.95729983
12 825.662230077
13 292.468245269
14 0
15 0
16 0
EOD
$series_6 << EOD
2 -1485.09590059
3 1103.09263423
4 2825.58009563
5 3978.13248958
6 4637.51522753
7 4837.01154763
8 4594.79546925
9 3922.15754074
10 2826.7197347
11 1555.95729983
12 825.662230077
13 292.468245269
14 -82.5317547305
15 -457.531754731
16 -832.531754731
EOD
$series_7 << EOD
1 1.54178119618
2 472.214833602
3 1413.56093841
4 2095.44027996
5 2284.1499655
6 2012.9732332
7 1300.08410241
8 156.773121492
9 -1409.33773695
10 -3150.77322423
11 -3175.05871537
12 -3002.24312157
13 -2588.70178823
14 -1882.69220962
15 -1176.68263101
16 -470.673052406
EOD
$series_8 << EOD
2 -1485.09590059
3 1103.09263423
4 2825.58009563
5 3978.13248958
6 4637.51522753
7 4837.01154763
8 4594.79546925
9 3922.15754074
10 2826.7197347
11 1555.95729983
12 825.662230077
13 292.468245269
14 -82.5317547305
15 -457.531754731
16 -832.531754731
EOD
$series_9 << EOD
1 1.54178119618
2 472.214833602
3 1413.56093841
4 2095.44027996
5 2284.1499655
6 2012.9732332
7 1300.08410241
8 156.773121492
9 -1409.33773695
10 -3150.77322423
11 -3175.05871537
12 -3002.24312157
13 -2588.70178823
14 -1882.69220962
15 -1176.68263101
16 -470.673052406
EOD
$series_10 << EOD
13 292.5
12 825.7
11 1556
10 2826.7
9 3922.2
8 4594.8
7 4837
6 4637.5
5 3978.1
4 2825.6
3 1413.6
2 472.2
1 1.5
EOD
set terminal svg size 720,645 dynamic noenhanced font 'sans-serif,19' background rgb 'white'
set output 'goodman_bray_forces.svg'
marker = 0.6
set key spacing 0.92
plot $series_1 using 1:2 with filledcurves closed fillcolor rgb '#BDBDBD' fillstyle transparent solid 0.21 noborder title 'stays', \
     $series_2 using 1:2 with filledcurves closed fillcolor rgb '#0072B2' fillstyle transparent solid 0.27 noborder title 'slides', \
     $series_3 using 1:2 with filledcurves closed fillcolor rgb '#E69F00' fillstyle transparent solid 0.3 noborder title 'topples', \
     $series_4 using 1:2 with lines linewidth 1.2 dashtype solid linecolor rgb '#666666' notitle, \
     $series_5 using 1:2 with lines linewidth 4 dashtype solid linecolor rgb '#000000' title 'acting force', \
     $series_6 using 1:2 with lines linewidth 2.5 dashtype (12,6) linecolor rgb '#D55E00' title 'needed against toppling', \
     $series_7 using 1:2 with lines linewidth 3 dashtype (3,5) linecolor rgb '#0072B2' title 'needed against sliding', \
     $series_8 using 1:2 with points pointtype 9 pointsize marker*1.2 linewidth 2 linecolor rgb '#D55E00' notitle, \
     $series_9 using 1:2 with points pointtype 5 pointsize marker*1 linewidth 2 linecolor rgb '#0072B2' notitle, \
     $series_10 using 1:2 with points pointtype 6 pointsize marker*2.2 linewidth 2 linecolor rgb '#000000' title 'acting, printed by Goodman & Bray (1976)'
set terminal pngcairo size 1440,1290 noenhanced font 'sans,19' fontscale 1.5 linewidth 2 pointscale 2 background rgb 'white'
set output 'goodman_bray_forces.png'
marker = 1
set key spacing 1.1
replot
set output
