package org.mechservice.solver.force.law;

import java.util.List;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.Side;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.symbol.Scalar;

/**
 * The laws of forces between two bodies: each a formula of the relative motion of two frames and of
 * its coefficients, from which the code of a model and the methods of a {@link PrintedLaw} come.
 *
 * <p>A printed law has 18 variables: displacement (3), rotation row by row (9), angular velocity
 * (3), rate of the displacement (3), as {@link Frames} has them. It puts out
 *
 * <ul>
 *   <li>the load: moment (3) and force (3) on body 2, then a number that is positive where the load
 *       has a direction;
 *   <li>its derivatives, each 6 × 6 row by row: by a small [rotation; displacement] of frame 2 with
 *       its velocities held, then by [angular velocity; rate]; entries that are always zero are
 *       left out;
 *   <li>results: potential energy, J, power of the part without it, W, and the output values.
 * </ul>
 */
public enum PairLaw {
  SPRING,
  /** A spring that pulls alone. */
  ROPE,
  /** A spring that pushes alone. */
  BUFFER,
  BUSHING,
  /** A bushing whose moment is not converted. */
  LINEAR_BUSHING,
  /** A contact at the closest point of the surface, which are further coefficients, see FOOT. */
  CONTACT,
  /** Likewise at that of the curve on which the centre moves. */
  CONTACT_OF_CENTRE;

  /** Number of variables of a printed law. */
  public static final int VARIABLES = 18;

  /** Place in a printed load of the number that is positive where it has a direction. */
  public static final int DIRECTION = 6;

  /** Places in printed results. */
  public static final int POTENTIAL = 0;

  public static final int POWER = 1;
  public static final int VALUES = 2;

  /**
   * First of the five coefficients of a contact that the search for the closest point gives: s,
   * h(s), h′(s), h″(s) and h(x), as {@link ClosestPoint#curve} writes them.
   */
  public static final int FOOT = 8;

  /** Returns the law of a spring and damper between points. */
  public static PairLaw of(SpringDamper spring) {
    return switch (spring.side()) {
      case BOTH -> SPRING;
      case ABOVE -> ROPE;
      case BELOW -> BUFFER;
    };
  }

  /** Returns the law of a bushing. */
  public static PairLaw of(Bushing bushing) {
    return bushing.law() == Bushing.Law.ENERGY ? BUSHING : LINEAR_BUSHING;
  }

  /** Returns the law of a contact at one of its curves. */
  public static PairLaw of(Contact contact) {
    return contact.tracks().isEmpty() ? CONTACT : CONTACT_OF_CENTRE;
  }

  /** Returns the number of coefficients. */
  public int coefficientCount() {
    return symbols().size();
  }

  /** Returns how many of them, the first, are the same in a run. */
  public int settledCount() {
    return this == CONTACT || this == CONTACT_OF_CENTRE ? FOOT : coefficientCount();
  }

  /**
   * Returns the coefficient, a smoothing, for which a law is printed twice: with zero in its place,
   * and for positive numbers; −1 if it is printed once.
   */
  public int smoothing() {
    return this == SPRING ? -1 : symbols().indexOf("eps");
  }

  /** Returns the names of the coefficients in printed methods. */
  public List<String> symbols() {
    return switch (this) {
      case SPRING, ROPE, BUFFER -> SpringLaw.SYMBOLS;
      case BUSHING, LINEAR_BUSHING -> BushingLoad.SYMBOLS;
      case CONTACT, CONTACT_OF_CENTRE -> ContactLoad.SYMBOLS;
    };
  }

  /**
   * Returns the load as formulas.
   *
   * @param x relative motion of the frames
   * @param coefficients in the order of the element's, those of a contact followed by the foot
   */
  public PairLoad of(Frames x, List<Scalar> coefficients) {
    return switch (this) {
      case SPRING -> spring(Side.BOTH, x, coefficients);
      case ROPE -> spring(Side.ABOVE, x, coefficients);
      case BUFFER -> spring(Side.BELOW, x, coefficients);
      case BUSHING -> bushing(true, x, coefficients);
      case LINEAR_BUSHING -> bushing(false, x, coefficients);
      case CONTACT -> contact(false, x, coefficients);
      case CONTACT_OF_CENTRE -> contact(true, x, coefficients);
    };
  }

  /**
   * Returns why a load has no direction, for messages.
   *
   * @param results what {@link PrintedLaw#results} gave there
   */
  public String whyUndirected(double[] results) {
    return switch (this) {
      case SPRING, ROPE, BUFFER ->
          "Its two points coincide, so its tension of "
              + results[VALUES + 2]
              + " N has no direction.";
      case BUSHING, LINEAR_BUSHING ->
          "Its frames are turned by half a turn, where a rotation vector changes its sign.";
      case CONTACT, CONTACT_OF_CENTRE -> "It has no normal.";
    };
  }

  /** Returns what to do about a load without direction, for messages. */
  public String adviceUndirected() {
    return switch (this) {
      case SPRING, ROPE, BUFFER ->
          "Move one of the points, or use a bushing, which needs no direction.";
      case BUSHING, LINEAR_BUSHING ->
          "Turn one of the frames, or use a joint with a spring for large rotations.";
      case CONTACT, CONTACT_OF_CENTRE -> "Look at its profile.";
    };
  }

  private static PairLoad spring(Side side, Frames x, List<Scalar> c) {
    return new SpringLoad(SpringLaw.of(side, c), x.displacement(), x.rate());
  }

  private static PairLoad bushing(boolean byEnergy, Frames x, List<Scalar> c) {
    return new BushingLoad(x, c.subList(0, 36), c.subList(36, 72), c.subList(72, 78), byEnergy);
  }

  private static PairLoad contact(boolean ofCentre, Frames x, List<Scalar> c) {
    Nearby near = new Nearby(c.get(FOOT), c.get(9), c.get(10), c.get(11));
    Scalar along = x.displacement().x();
    ClosestFoot foot = new ClosestFoot(near, c.get(12), along, x.displacement().z(), ofCentre);
    return new ContactLoad(x, ContactLoad.Coefficients.of(c), foot);
  }

  /** A curve given at one place, to second order. */
  private record Nearby(Scalar way, Scalar height, Scalar slope, Scalar bend)
      implements ClosestFoot.Curve {
    @Override
    public ClosestFoot.Curve at(Scalar other) {
      Scalar step = other.minus(way);
      return new Nearby(other, height.plus(slope.times(step)), slope.plus(bend.times(step)), bend);
    }
  }
}
