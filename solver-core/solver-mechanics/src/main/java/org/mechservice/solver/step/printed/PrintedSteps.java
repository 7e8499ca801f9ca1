package org.mechservice.solver.step.printed;

import org.mechservice.solver.step.StepKernel;
import org.mechservice.solver.step.StepKind;

/**
 * The printed steps. Printed from its equations; do not edit. PrintedStepsTest compares it with
 * them and
 * prints it anew with -Dgolden.write=true.
 */
public final class PrintedSteps {
  private PrintedSteps() {}

  /**
   * Returns the methods of a kind of step.
   */
  public static StepKernel of(StepKind kind) {
    return switch (kind) {
      case TURN -> new PrintedTurn();
      case SLIDE -> new PrintedSlide();
      case SCREW -> new PrintedScrew();
      case BALL -> new PrintedBall();
      case BALL_BACK -> new PrintedBallBack();
      case AXES_X -> new PrintedAxesX();
      case AXES_Y -> new PrintedAxesY();
      case AXES_Z -> new PrintedAxesZ();
      case TURN_ARMED -> new PrintedTurnArmed();
      case SLIDE_ARMED -> new PrintedSlideArmed();
      case SCREW_ARMED -> new PrintedScrewArmed();
      case BALL_ARMED -> new PrintedBallArmed();
      case BALL_BACK_ARMED -> new PrintedBallBackArmed();
    };
  }
}
