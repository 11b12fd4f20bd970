# Single block
# Draw again, in this folder: gnuplot single_block.gp
set encoding utf8
set minussign
set title 'Single block'
set border 31 linewidth 1 linecolor rgb '#666666'
set tics nomirror scale 0.6 textcolor rgb 'black'
set style textbox opaque fillcolor rgb 'white' noborder margins 0.4,0.2
set size ratio -1
set key at screen 0.5,0.00441014332966 center bottom vertical maxcols 1 Left reverse samplen 2 width 1
set bmargin at screen 0.163175303197
set xrange [-2.81907786236:2.81907786236]
set xlabel 'distance from the toe (m)'
set xtics 1
set yrange [-1.44643460786:6.40055004592]
set ylabel 'height above the toe (m)'
set ytics 1
set label '100 kN/m' at 1.54601999912,6.14263812385 left front offset character 0,0 textcolor rgb '#000000'
set label '1' at -0.556214119584,2.99008793402 center front offset character 0,0 textcolor rgb '#000000'
$series_1 << EOD
-2.81907786236 -1.02606042998
2.81907786236 1.02606042998
2.81907786236 -1.44643460786
-2.81907786236 -1.44643460786
EOD
$series_2 << EOD
0 0
0.939692620786 0.342020143326
-1.11242823917 5.98017586804
-2.05212085995 5.63815572472
EOD
$series_3 << EOD
0 0
0.939692620786 0.342020143326
-1.11242823917 5.98017586804
-2.05212085995 5.63815572472
0 0
nan nan
EOD
$series_4 << EOD
-2.81907786236 -1.02606042998
2.81907786236 1.02606042998
EOD
$series_5 << EOD
0 0 0.115746281623 0.868097112171
EOD
$series_6 << EOD
0.851891757857 6.14263812385 1.43062316597 6.14263812385
EOD
set terminal svg size 720,907 dynamic noenhanced font 'sans-serif,19' background rgb 'white'
set output 'single_block.svg'
marker = 0.6
set key spacing 0.92
plot $series_1 using 1:2 with filledcurves closed fillcolor rgb '#C8B99A' fillstyle transparent solid 0.5 noborder notitle, \
     $series_2 using 1:2 with filledcurves closed fillcolor rgb '#E69F00' fillstyle transparent solid 0.5 noborder title 'topples', \
     $series_3 using 1:2 with lines linewidth 1.2 dashtype solid linecolor rgb '#000000' notitle, \
     $series_4 using 1:2 with lines linewidth 2.5 dashtype solid linecolor rgb '#000000' notitle, \
     $series_5 using 1:2:($3-$1):($4-$2) with vectors head filled size screen 0.013,20 linewidth 2.2 linecolor rgb '#000000' title 'base reaction', \
     $series_6 using 1:2:($3-$1):($4-$2) with vectors head filled size screen 0.013,20 linewidth 2.2 linecolor rgb '#000000' notitle
set terminal pngcairo size 1440,1814 noenhanced font 'sans,19' fontscale 1.5 linewidth 2 pointscale 2 background rgb 'white'
set output 'single_block.png'
marker = 1
set key spacing 1.1
replot
set output
