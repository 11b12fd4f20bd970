# Change of the factor of safety
# Draw again, in this folder: gnuplot sensitivities.gp
set encoding utf8
set minussign
set title 'Change of the factor of safety'
set border 31 linewidth 1 linecolor rgb '#666666'
set tics nomirror scale 0.6 textcolor rgb 'black'
set style textbox opaque fillcolor rgb 'white' noborder margins 0.4,0.2
set key at screen 0.5,0.0056338028169 center bottom vertical maxcols 1 Left reverse samplen 2 width 1
set bmargin at screen 0.208450704225
set xrange [-0.354406289308:0.231606289308]
set xlabel 'change of the factor of safety'
set grid xtics linetype 1 linewidth 0.5 linecolor rgb '#D8D8D8'
set xtics 0.1
set yrange [0.4:7.6]
set ylabel ''
set ytics ('water: filled ratio,'."\n".'+0.1' 7, 'strength: friction'."\n".'angle, +1 deg' 6, 'failure plane: dip,'."\n".'+1 deg' 5, 'strength: cohesion,'."\n".'+10 kPa' 4, 'rock: unit weight,'."\n".'+1 kN/m³' 3, 'slope: face dip,'."\n".'+1 deg' 2, 'tension crack: base'."\n".'below crest, +1 m' 1)
set label '−0.18' at -0.188904,7 right front offset character 0,0 textcolor rgb '#000000'
set label '+0.061' at 0.066104,6 left front offset character 0,0 textcolor rgb '#000000'
set label '−0.042' at -0.046404,5 right front offset character 0,0 textcolor rgb '#000000'
set label '+0.023' at 0.027604,4 left front offset character 0,0 textcolor rgb '#000000'
set label '+0.011' at 0.016104,3 left front offset character 0,0 textcolor rgb '#000000'
set label '−0.0093' at -0.014204,2 right front offset character 0,0 textcolor rgb '#000000'
set label '+0.0054' at 0.010304,1 left front offset character 0,0 textcolor rgb '#000000'
$series_1 << EOD
0 5.68 0.0612 6.32
0 3.68 0.0227 4.32
0 2.68 0.0112 3.32
0 0.68 0.0054 1.32
EOD
$series_2 << EOD
-0.184 6.68 0 7.32
-0.0415 4.68 0 5.32
-0.0093 1.68 0 2.32
EOD
$series_3 << EOD
0 0.4
0 7.6
EOD
set terminal svg size 720,710 dynamic noenhanced font 'sans-serif,19' background rgb 'white'
set output 'sensitivities.svg'
marker = 0.6
set key spacing 0.92
plot $series_1 using (0.5*($1+$3)):(0.5*($2+$4)):1:3:2:4 with boxxyerror fillcolor rgb '#0072B2' fillstyle solid noborder title 'makes it safer', \
     $series_2 using (0.5*($1+$3)):(0.5*($2+$4)):1:3:2:4 with boxxyerror fillcolor rgb '#D55E00' fillstyle solid noborder title 'makes it less safe', \
     $series_3 using 1:2 with lines linewidth 1.5 dashtype solid linecolor rgb '#000000' notitle
set terminal pngcairo size 1440,1420 noenhanced font 'sans,19' fontscale 1.5 linewidth 2 pointscale 2 background rgb 'white'
set output 'sensitivities.png'
marker = 1
set key spacing 1.1
replot
set output
