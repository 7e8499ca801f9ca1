package org.mechservice.sim.emit.plan;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** How the code of a model is laid out; the results are the same bits in any form. */
public enum CodeForm {
  /** Whichever suits the model. */
  AUTO,
  /** Every operation written out. */
  STRAIGHT,
  /** One method for sections of the same structure, called for each body. */
  SHARED;

  /**
   * Operations of a program below which its straight line serves as well. Measured in fresh virtual
   * machines, processor time of compilers included, shared kernels beside straight lines: chains of
   * 20 links (5 400 operations) take as long for 1 000 and for 10 000 evaluations; of 60 (16 000)
   * 0.55 and 0.6 of the time; of 200 (55 000) 0.4 and 0.5. One evaluation by compiled code then
   * takes 0.9 to 1.1 of the time.
   */
  public static final int LEAST_OPERATIONS = 10_000;

  /** What there is, for people. */
  public static final String LABELS = "auto, straight or shared";

  /** Returns its name in options. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the form of a name, if there is one. */
  public static Optional<CodeForm> named(String label) {
    return Stream.of(values()).filter(form -> form.label().equals(label)).findFirst();
  }
}
