package org.mechservice.solver.kinematics.pair;

/**
 * Displacement along an axis less pitch times the angle about it, to the nearest whole turn: a
 * screw may have turned any number of times.
 */
final class ScrewGap extends PairFunction {
  private final Displacement displacement;
  private final Turn turn;
  private final double pitch;

  /**
   * @param pitch m/rad
   */
  ScrewGap(String label, Displacement displacement, Turn turn, double pitch) {
    super(label);
    this.displacement = displacement;
    this.turn = turn;
    this.pitch = pitch;
  }

  @Override
  public <T> T as(PairForms<T> forms) {
    return forms.screwGap(displacement.as(forms), turn.as(forms), pitch);
  }

  @Override
  public boolean isLength() {
    return true;
  }

  @Override
  public double evaluate(RelativeMotion r) {
    return gap(displacement.evaluate(r), turn.evaluate(r));
  }

  @Override
  public double evaluateFar(RelativeMotion r) {
    return gap(displacement.evaluateFar(r), turn.evaluateFar(r));
  }

  private double gap(double way, double angle) {
    double gap = way - pitch * angle;
    for (int i = 0; i < 6; i++) {
      gradient[i] = displacement.gradient[i] - pitch * turn.gradient[i];
    }
    double lead = 2 * Math.PI * pitch;
    return lead == 0 ? gap : gap - lead * Math.rint(gap / lead);
  }

  @Override
  public void addCurvature(RelativeMotion r, double factor, double[] c) {
    turn.addCurvature(r, -pitch * factor, c);
  }
}
