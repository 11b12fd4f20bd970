#!/usr/bin/env bash
# Results are neither lost nor mixed: one folder holds one result of one case, written by one process, and nothing is
# written through a symbolic link in it.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
write_good_fit good_fit.toml
"$program" init relaxation >blocks.toml

title "a planted link leads no result out of its folder"
echo precious >victim
mkdir victims
for link in resolved.toml result.json report.html results.csv figures/section.gp figures/section.svg \
    figures/section.png files.txt; do
    rm -rf results
    mkdir -p "results/good/$(dirname "$link")"
    ln -s "$work/victim" "results/good/$link"
    delabole run good.toml
    expect_status 5
    expect_error "delabole: cannot write results/good/$link: it is a symbolic link"
    expect_one_line_of_error
    expect "$link: the victim is as it was" test "$(cat victim)" == precious
done
for link in figures frames; do
    rm -rf results
    mkdir -p results/good
    ln -s "$work/victims" "results/good/$link"
    delabole run good.toml
    expect_status 5
    expect_error "delabole: cannot write results/good/$link: it is a symbolic link"
    expect "$link: nothing was written there" test -z "$(ls -A victims)"
done
for link in results results/good; do
    rm -rf results
    mkdir -p "$(dirname "$link")"
    ln -s "$work/victims" "$link"
    delabole run good.toml
    expect_status 5
    expect_error "delabole: cannot write $link: it is a symbolic link"
    expect "$link: nothing was written there" test -z "$(ls -A victims)"
done
rm -rf results
mkdir results linked
ln -s "$work/victim" linked/relaxation.checkpoint
delabole run blocks.toml --out linked
expect_status 5
expect_error 'delabole: cannot write linked/relaxation.checkpoint: it is a symbolic link'
rm linked/relaxation.checkpoint
ln -s "$work/new_victim" linked/evaluations.sqlite
delabole sensitivity "$source_folder/cases/relaxation/single_block_probability.toml" --out linked
expect_status 5
expect_error 'delabole: cannot write linked/evaluations.sqlite: it is a symbolic link'
expect "no store elsewhere" test ! -e new_victim
expect "the victim is as it was" test "$(cat victim)" == precious

title "several cases with one --out: a folder for each, and what each answers"
cp good.toml second.toml
delabole run good.toml second.toml --out several
expect_status 0
expect_complete_results several/good
expect_complete_results several/second
expect "an overview at the end" grep -qE '^second +FS [0-9.]+: .*several/second$' "$scratch/out"
mkdir other
cp good.toml other/good.toml
delabole run good.toml other/good.toml --out of_one_name
expect_status 2
expect_error "good.toml and other/good.toml would both be written into of_one_name/good: rename one of them, or run it alone"
expect "nothing was written" test ! -e of_one_name
mkdir planted
ln -s "$work/victims" planted/good
delabole run good.toml second.toml --out planted
expect_status 5
expect_error 'delabole: cannot write planted/good: it is a symbolic link'
expect "nothing was written through the link" test -z "$(ls -A victims)"

title "the folder that --out names may be a link: its user has made it"
ln -s victims named
delabole run good.toml --out named --quiet
expect_status 0
expect_complete_results victims

title "cases of one name are not written into one folder"
mkdir a b
cp good.toml a/x.toml
cp good.toml b/x.toml
delabole run a/x.toml b/x.toml
expect_status 2
expect_error 'delabole: a/x.toml and b/x.toml would both be written into results/x'
expect_one_line_of_error
expect "nothing was written" test -z "$(ls results)"

title "the name of a case leads out of no folder"
rmdir results
before=$(ls -A; echo ...toml; echo ..toml)
cp good.toml ...toml
cp good.toml ..toml
for name in ...toml ..toml; do
    delabole run "$name"
    expect_status 2
    expect_error 'cannot be the name of a folder in results: name one with --out'
done
for name in ...toml ..toml; do
    delabole run good.toml "$name" --out several
    expect_status 2
    expect_error "cannot be the name of a folder in several: rename $name"
done
expect "nothing was written" test "$(ls -A | sort)" == "$(sort <<<"$before")"
delabole run ...toml --out dots --quiet
expect_status 0
expect_complete_results dots

title "what an earlier case has left goes, what is not delabole's stays"
delabole run "$source_folder/cases/relaxation/free_slide.toml" --out one --quiet
expect_status 0
expect "there are frames" test -n "$(ls one/frames)"
expect "there is a history" test -s one/history.csv
echo mine >one/notes.txt
echo mine >one/frames/notes.vtp
delabole run good.toml --out one --quiet
expect_status 0
delabole run good.toml --out fresh --quiet
rm one/notes.txt
expect "only frames of somebody else are left" test "$(ls one/frames)" == notes.vtp
rm -r one/frames
expect "otherwise the folder is as a new one" test "$(cd one && find . | sort)" == "$(cd fresh && find . | sort)"
expect "files.txt lists all files" test "$(sed 1d one/files.txt | sort)" == \
    "$(cd one && find . -type f ! -name files.txt -printf '%P\n' | sort)"
delabole fit good_fit.toml --out one --quiet
expect_status 0
expect "another command leaves nothing of it either" test ! -e one/results.csv
delabole run good.toml --set 'water.water_depth=5 m' --out one
expect_status 3
expect_complete_results one

title "a sweep takes no other table's name, nor one that no file can have"
cat good.toml - >swept.toml <<'CASE'

[[sweep]]
name = "results"

[[sweep.vary]]
input = "water.water_depth"
values = ["0 m", "3 m"]

[[sweep.curve]]
label = "safety"
output = "factor_of_safety"
CASE
delabole run swept.toml --out swept
expect_status 5
expect_error 'delabole: cannot write swept/results.csv: the result has another table of this name: rename the sweep'
expect "nothing says that all is there" refuse test -e swept/result.json
sed 's/^name = "results"/name = "water"/' swept.toml >water.toml
delabole run water.toml --out swept --quiet
expect_status 0
expect "both tables" test -s swept/results.csv -a -s swept/water.csv
expect "the model's figure of that name, and the sweep's" test -s swept/figures/water.svg -a -s swept/figures/water_2.svg
sed "s/^name = \"results\"/name = \"$(printf '%0101d' 0)\"/" swept.toml >long.toml
delabole check long.toml
expect_status 3
expect_error 'must consist of at most 100 letters, digits, - and _'

title "a second process is refused while one writes"
# The first process writes as long as its gnuplot waits.
mkdir waiting
cat >waiting/gnuplot <<STUB
#!/usr/bin/env bash
touch "$work/drawing"
until [[ -e "$work/go_on" ]]; do sleep 0.05; done
exit 1
STUB
chmod +x waiting/gnuplot
PATH=$work/waiting:$PATH "$program" run good.toml --out shared >/dev/null 2>&1 </dev/null &
child=$!
until [[ -e drawing ]] || ! kill -0 "$child" 2>/dev/null; do
    sleep 0.05
done
before=$(cd shared && find . | sort)
for arguments in "run $source_folder/cases/relaxation/free_slide.toml" "fit good_fit.toml"; do
    # shellcheck disable=SC2086
    delabole $arguments --out shared
    expect_status 5
    expect_error 'delabole: cannot write shared: another delabole is writing a result there'
    expect_one_line_of_error
done
expect "nothing was written" test "$(cd shared && find . | sort)" == "$before"
touch go_on
status=0
wait "$child" || status=$?
expect_status 0
expect_complete_results shared
delabole run good.toml --out shared --quiet
expect_status 0
expect_silence err

title "--help says so"
delabole run --help
expect_output 'files.txt'

finish
