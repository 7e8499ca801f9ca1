package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.mechservice.solver.symbol.Scalar;

/**
 * The laws of forces between two bodies: each a formula of the relative motion of two frames and of
 * its coefficients, from which the code of a model and the methods of a {@link PrintedLaw} come.
 * One that needs nothing but numbers is an element of MechML by its {@link ForceRow}.
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
  SPRING((x, c) -> spring(Side.BOTH, x, c), SpringLaw.SYMBOLS, SpringLoad.UNDIRECTED),
  /** A spring that pulls alone. */
  ROPE((x, c) -> spring(Side.ABOVE, x, c), SpringLaw.SYMBOLS, SpringLoad.UNDIRECTED),
  /** A spring that pushes alone. */
  BUFFER((x, c) -> spring(Side.BELOW, x, c), SpringLaw.SYMBOLS, SpringLoad.UNDIRECTED),
  BUSHING((x, c) -> bushing(true, x, c), BushingLoad.SYMBOLS, BushingLoad.UNDIRECTED),
  /** A bushing whose moment is not converted. */
  LINEAR_BUSHING((x, c) -> bushing(false, x, c), BushingLoad.SYMBOLS, BushingLoad.UNDIRECTED),
  /** A contact at the closest point of the surface, which are further coefficients, see FOOT. */
  CONTACT((x, c) -> contact(false, x, c), ContactLoad.SYMBOLS, Undirected.NEVER),
  /** Likewise at that of the curve on which the centre moves. */
  CONTACT_OF_CENTRE((x, c) -> contact(true, x, c), ContactLoad.SYMBOLS, Undirected.NEVER),
  INVERSE_SQUARE(InverseSquareLoad::new, InverseSquareLoad.ROW, InverseSquareLoad.UNDIRECTED),
  ROTATION_FRICTION(RotationFrictionLoad::new, RotationFrictionLoad.ROW, Undirected.NEVER);

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

  @SuppressWarnings("ImmutableEnumChecker") // has no state
  private final BiFunction<Frames, List<Scalar>, PairLoad> formula;

  @SuppressWarnings("ImmutableEnumChecker") // is not modifiable
  private final List<String> symbols;

  @SuppressWarnings("ImmutableEnumChecker") // a record of texts and a number
  private final Undirected undirected;

  @SuppressWarnings("ImmutableEnumChecker") // its lists are not modifiable
  private final Optional<ForceRow> row;

  /** A law of an element of its own. */
  PairLaw(
      BiFunction<Frames, List<Scalar>, PairLoad> formula,
      List<String> symbols,
      Undirected undirected) {
    this.formula = formula;
    this.symbols = symbols;
    this.undirected = undirected;
    this.row = Optional.empty();
  }

  /** A law that is an element by its row. */
  PairLaw(BiFunction<Frames, List<Scalar>, PairLoad> formula, ForceRow row, Undirected undirected) {
    this.formula = formula;
    this.symbols = row.attributes().stream().map(ForceRow.Attribute::name).toList();
    this.undirected = undirected;
    this.row = Optional.of(row);
  }

  /** Returns the row of the element that it is, if it is one. */
  public Optional<ForceRow> row() {
    return row;
  }

  /** Returns the law that is an element of MechML. */
  public static Optional<PairLaw> ofElement(String element) {
    return Stream.of(values())
        .filter(law -> law.row.filter(row -> row.element().equals(element)).isPresent())
        .findFirst();
  }

  /** Returns the law of a spring and damper between points. */
  public static PairLaw ofSpring(Side side) {
    return switch (side) {
      case BOTH -> SPRING;
      case ABOVE -> ROPE;
      case BELOW -> BUFFER;
    };
  }

  /** Returns the number of coefficients. */
  public int coefficientCount() {
    return symbols.size();
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
    return this == SPRING ? -1 : symbols.indexOf("eps");
  }

  /** Returns the names of the coefficients in printed methods. */
  public List<String> symbols() {
    return symbols;
  }

  /**
   * Returns the load as formulas.
   *
   * @param x relative motion of the frames
   * @param coefficients in the order of the element's, those of a contact followed by the foot
   */
  public PairLoad of(Frames x, List<Scalar> coefficients) {
    return formula.apply(x, coefficients);
  }

  /** Returns why a load may have no direction. */
  public Undirected undirected() {
    return undirected;
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
    public ClosestFoot.Curve moved(Scalar by) {
      return new Nearby(
          way.plus(by), height.plus(slope.times(by)), slope.plus(bend.times(by)), bend);
    }
  }
}
