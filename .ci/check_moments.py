#!/usr/bin/env python3
"""Judges bending moments of planar wells beside an independent finite-difference beam, at the default settings.

The beam is that of another programmer (fd_beam.py DRILLGAP: prints a row a well and operation, without verdict). Here:
  - hook load within 0.02 % of it, contact within 0.2 %;
  - the largest moment within 3 % of the beam's, and not more than 2 % below it;
  - moments along the string within 5 % of the largest, root mean square within 1 %, where rows of a profile, whose string has
    slid, are compared within a metre of their place.

Usage: check_moments.py FD_BEAM DRILLGAP      needs numpy and scipy; prints the table; exit status 1 on any fault
"""
import subprocess
import sys

FORCES = {"hook": 2.0e-4, "contact": 2.0e-3}
MOST_ABOVE, MOST_BELOW = 0.03, 0.02
MOST_OFF, MOST_RMS = 5.0, 1.0       # per cent of the largest
COLUMNS = ("hook", "hook_ref", "contact", "contact_ref", "moment", "moment_ref", "bend", "off", "rms")
ROWS = 10                           # five wells, up and down


def faults_of(row):
    """What is wrong with one row, a table of COLUMNS."""
    found = []
    for name, within in FORCES.items():
        if not abs(row[name]/row[name + "_ref"] - 1.0) <= within:
            found.append(f"{name} {row[name]} kN, reference {row[name + '_ref']} kN")
    share = row["moment"]/row["moment_ref"] - 1.0
    if not -MOST_BELOW <= share <= MOST_ABOVE:
        found.append(f"largest moment off by {100.0*share:.1f} %")
    if not row["off"] <= MOST_OFF:
        found.append(f"a moment off by {row['off']} % of the largest")
    if not row["rms"] <= MOST_RMS:
        found.append(f"root mean square of moments off by {row['rms']} % of the largest")
    return found


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    run = subprocess.run([sys.executable, sys.argv[1], sys.argv[2]], capture_output=True, text=True)
    print(run.stdout + run.stderr[-2000:], end="")
    faults, rows = [], 0
    if run.returncode:
        faults.append(f"{sys.argv[1]} ended with status {run.returncode}")
    for line in run.stdout.splitlines()[1:]:
        well, operation, *fields = line.split()
        if len(fields) != len(COLUMNS):
            faults.append(line)
            continue
        rows += 1
        values = [float(field.rstrip("%")) for field in fields]
        faults += [f"{well} {operation}: {fault}" for fault in faults_of(dict(zip(COLUMNS, values)))]
    if rows != ROWS:
        faults.append(f"{rows} rows of {ROWS}")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
