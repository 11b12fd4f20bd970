"""A million samples of an uncertain slope, its factors of safety, and how often it fails."""

import sys
import time

import numpy as np

import delabole

case = delabole.read(sys.argv[1] if len(sys.argv) > 1 else "cases/plane_failure/sau_mau_ping_probability.toml")
samples = case.sample(1_000_000, method="monte_carlo", seed=1)
start = time.process_time()
evaluation = case.evaluate(samples)
seconds = time.process_time() - start
factors = evaluation.factor_of_safety
answered = factors[np.isfinite(factors)]
print(f"{factors.size} factors of safety in {seconds:.2f} s of processor time")
print(f"mean {answered.mean():.3f}, standard deviation {answered.std():.3f}")
print(f"probability of failure {np.mean(answered < 1):.4f}")
print("without an answer:", evaluation.failures)
