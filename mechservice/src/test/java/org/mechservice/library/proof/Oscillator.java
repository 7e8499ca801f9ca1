package org.mechservice.library.proof;

/**
 * A damped oscillator x'' + 2 ζ ω x' + ω² x = a(t), in closed form.
 *
 * @param frequency ω, rad/s; 0: a free mass
 * @param ratio ζ, below 1
 */
record Oscillator(double frequency, double ratio) {
  private double damped() {
    return frequency * Math.sqrt(1 - ratio * ratio);
  }

  /** Returns the position after an impulse of 1 m/s. */
  double response(double s) {
    if (frequency == 0) {
      return s;
    }
    return Math.exp(-ratio * frequency * s) * Math.sin(damped() * s) / damped();
  }

  /** Returns the velocity after an impulse of 1 m/s. */
  double rate(double s) {
    if (frequency == 0) {
      return 1;
    }
    double decay = Math.exp(-ratio * frequency * s);
    return decay * (Math.cos(damped() * s) - ratio * frequency / damped() * Math.sin(damped() * s));
  }

  /** Returns the position of the free motion. */
  double position(double q0, double v0, double s) {
    return q0 * (rate(s) + 2 * ratio * frequency * response(s)) + v0 * response(s);
  }

  /** Returns the velocity of the free motion. */
  double velocity(double q0, double v0, double s) {
    return -q0 * frequency * frequency * response(s) + v0 * rate(s);
  }
}
