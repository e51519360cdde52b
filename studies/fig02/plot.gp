# fig02.svg from result.csv: sh studies/figures.sh PROGRAM fig02
set terminal svg enhanced size 420,320 font 'DejaVu Sans,10'
set output 'fig02/fig02.svg'
set encoding utf8
set datafile separator ','
set tics nomirror out
set border 3
set xlabel '{/:Italic γ}'
set ylabel 'W-cycles'
set logscale y
set xrange [0:1]
set key top center
plot '< head -n 12 fig02/result.csv' using 2:3 with linespoints pt 7 ps 0.6 lc rgb '#0072B2' title '{/:Italic ε} = 10^{-5}', \
     '< head -n 12 fig02/result.csv' using 2:4 with linespoints pt 5 ps 0.6 lc rgb '#D55E00' title '{/:Italic ε} = 10^{-8}'
