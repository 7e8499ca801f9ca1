package org.mechservice.sim.emit.plan;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** Layout of the code of a model; results have the same bits in all forms. */
public enum CodeForm {
  /** The form that suits the model. */
  AUTO,
  /** Every operation written out. */
  STRAIGHT,
  /** One shared method for sections of the same structure, called for each body. */
  SHARED;

  /**
   * Number of operations of a program below which straight-line code is as fast. Measured in fresh
   * virtual machines, processor time of compilers included, shared kernels beside straight lines:
   * chains of 20 links (5 400 operations) take as long for 1 000 and for 10 000 evaluations; of 60
   * (16 000) 0.55 and 0.6 of the time; of 200 (55 000) 0.4 and 0.5. One evaluation by compiled code
   * then takes 0.9 to 1.1 of the time.
   */
  public static final int LEAST_OPERATIONS = 10_000;

  /** Names of the forms, for messages. */
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
