# Old Delabole, west face: section before and after 4 March 1967
# Draw again, in this folder: gnuplot section.gp
set encoding utf8
set minussign
set title 'Old Delabole, west face: section'."\n".'before and after 4 March 1967'
set border 31 linewidth 1 linecolor rgb '#666666'
set tics nomirror scale 0.6 textcolor rgb 'black'
set style textbox opaque fillcolor rgb 'white' noborder margins 0.4,0.2
set size ratio -1
set key at screen 0.5,0.00446428571429 center bottom vertical maxcols 1 Left reverse samplen 2 width 1
set bmargin at screen 0.313616071429
set xrange [-20:62]
set xlabel 'distance from the toe (m)'
set grid xtics linetype 1 linewidth 0.5 linecolor rgb '#D8D8D8'
set xtics 20
set yrange [96.84:185.1]
set ylabel 'elevation (m)'
set grid ytics linetype 1 linewidth 0.5 linecolor rgb '#D8D8D8'
set ytics 10
set label '575 ft' at -18.77,175.26 left front offset character 0,0.55 textcolor rgb '#000000'
set label '475 ft' at -18.77,144.78 left front offset character 0,0.55 textcolor rgb '#000000'
set label '425 ft' at -18.77,129.54 left front offset character 0,0.55 textcolor rgb '#000000'
set label '350 ft' at -18.77,106.68 left front offset character 0,0.55 textcolor rgb '#000000'
$series_1 << EOD
-20 106.68
0 106.68
24.961078666 175.26
62 175.26
62 96.84
-20 96.84
EOD
$series_2 << EOD
-20 175.26
62 175.26
EOD
$series_3 << EOD
-20 144.78
62 144.78
EOD
$series_4 << EOD
-20 129.54
62 129.54
EOD
$series_5 << EOD
-20 106.68
62 106.68
EOD
$series_6 << EOD
0 106.68
27.2434871267 129.54
34.0513792584 121.426670094
0 106.68
EOD
$series_7 << EOD
0 106.68
27.2434871267 129.54
34.0513792584 121.426670094
0 106.68
0 106.68
EOD
$series_8 << EOD
27.2434871267 129.54
32.0486406692 144.78
32.0486406692 144.78
37.3444940955 126.355164736
EOD
$series_9 << EOD
27.2434871267 129.54
32.0486406692 144.78
32.0486406692 144.78
37.3444940955 126.355164736
27.2434871267 129.54
EOD
$series_10 << EOD
-20 106.68
0 106.68
24.961078666 175.26
62 175.26
EOD
$series_11 << EOD
0 106.68
27.2434871267 129.54
41.6589477543 175.26
EOD
$series_12 << EOD
0 106.68
27.2434871267 129.54
EOD
$series_13 << EOD
27.2434871267 129.54
41.6589477543 175.26
EOD
$series_14 << EOD
27.2434871267 129.54
32.0486406692 144.78
EOD
$series_15 << EOD
0 106.68
7.5 114.28
10.5 114.78
19 122.58
22 123.28
29 129.58
35.5 150.68
43 175.26
EOD
$series_16 << EOD
0 106.68
7.5 114.28
10.5 114.78
19 122.58
22 123.28
29 129.58
35.5 150.68
43 175.26
EOD
set terminal svg size 640,896 dynamic noenhanced font 'sans-serif,19' background rgb 'white'
set output 'section.svg'
marker = 0.6
set key spacing 0.92
plot $series_1 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.5 noborder notitle, \
     $series_2 using 1:2 with lines linewidth 1 dashtype (3,5) linecolor rgb '#666666' notitle, \
     $series_3 using 1:2 with lines linewidth 1 dashtype (3,5) linecolor rgb '#666666' notitle, \
     $series_4 using 1:2 with lines linewidth 1 dashtype (3,5) linecolor rgb '#666666' notitle, \
     $series_5 using 1:2 with lines linewidth 1 dashtype (3,5) linecolor rgb '#666666' notitle, \
     $series_6 using 1:2 with filledcurves closed fillcolor rgb '#56B4E9' fillstyle transparent solid 0.55 noborder title 'water pressure', \
     $series_7 using 1:2 with lines linewidth 1 dashtype solid linecolor rgb '#0072B2' notitle, \
     $series_8 using 1:2 with filledcurves closed fillcolor rgb '#56B4E9' fillstyle transparent solid 0.55 noborder notitle, \
     $series_9 using 1:2 with lines linewidth 1 dashtype solid linecolor rgb '#0072B2' notitle, \
     $series_10 using 1:2 with lines linewidth 3 dashtype solid linecolor rgb '#000000' title 'ground before the failure', \
     $series_11 using 1:2 with lines linewidth 6 dashtype solid linecolor rgb '#009E73' title 'predicted after the failure', \
     $series_12 using 1:2 with lines linewidth 3 dashtype (12,6) linecolor rgb '#D55E00' title 'failure plane', \
     $series_13 using 1:2 with lines linewidth 3 dashtype (12,6) linecolor rgb '#CC79A7' title 'tension crack', \
     $series_14 using 1:2 with lines linewidth 5 dashtype solid linecolor rgb '#0072B2' title 'water in the crack', \
     $series_15 using 1:2 with lines linewidth 2 dashtype (3,5) linecolor rgb '#000000' notitle, \
     $series_16 using 1:2 with points pointtype 7 pointsize marker*1.3 linewidth 2 linecolor rgb '#000000' title 'observed after the failure'
set terminal pngcairo size 1280,1792 noenhanced font 'sans,19' fontscale 1.5 linewidth 2 pointscale 2 background rgb 'white'
set output 'section.png'
marker = 1
set key spacing 1.1
replot
set output
