package org.mechservice.solver.ode.solve;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.jumps.UndeclaredJumps;

/**
 * Options of an integration. Immutable: each method returns other options and leaves these as they
 * are.
 *
 * <pre>{@code
 * OdeOptions options = OdeOptions.standard().rtol(1e-8).atol(1e-10, 1e-6).method(OdeMethod.ODE15S);
 * }</pre>
 *
 * <p>The standard options: a relative tolerance of 1e-6 and an absolute one of 1e-9, method {@link
 * OdeMethod#AUTO}, steps of the method's own choice, at most a million of them, all of them kept
 * for {@link OdeSolution#at}, and an {@link IntegrationException} if the end is not reached.
 */
public final class OdeOptions {
  /** Receives the solution at times that were asked for. */
  @FunctionalInterface
  public interface OutputHandler {
    /**
     * Receives one state, in the order of integration. At a time at which an event has changed the
     * state it is the changed one.
     *
     * @param t the time asked for
     * @param y state there, length n; an array used again for the next one: copy what is to be kept
     */
    void accept(double t, double[] y);
  }

  private static final long MOST_STEPS = 1_000_000;

  private static final OdeOptions STANDARD = new OdeOptions();

  private double relativeTolerance = 1e-6;
  private List<Double> absoluteTolerance = List.of(1e-9);
  private OdeMethod method = OdeMethod.AUTO;
  private Mode accuracy = Mode.STANDARD;
  private double maxStep = Double.POSITIVE_INFINITY;
  private double initialStep;
  private int maxOrder;
  private long maxSteps = MOST_STEPS;
  private boolean keepSteps = true;
  private boolean returnFailures;
  private boolean searchUndeclaredJumps;
  private BooleanSupplier cancelled = () -> false;
  private List<OdeEvent> events = List.of();
  private List<StepHandler> stepHandlers = List.of();
  private List<RequestedTimes.Request> outputs = List.of();
  private long checkpointDistance;
  private Optional<Consumer<OdeCheckpoint>> checkpointHandler = Optional.empty();

  private OdeOptions() {}

  private OdeOptions(OdeOptions other) {
    relativeTolerance = other.relativeTolerance;
    absoluteTolerance = other.absoluteTolerance;
    method = other.method;
    accuracy = other.accuracy;
    maxStep = other.maxStep;
    initialStep = other.initialStep;
    maxOrder = other.maxOrder;
    maxSteps = other.maxSteps;
    keepSteps = other.keepSteps;
    returnFailures = other.returnFailures;
    searchUndeclaredJumps = other.searchUndeclaredJumps;
    cancelled = other.cancelled;
    events = other.events;
    stepHandlers = other.stepHandlers;
    outputs = other.outputs;
    checkpointDistance = other.checkpointDistance;
    checkpointHandler = other.checkpointHandler;
  }

  /** Returns the standard options. */
  public static OdeOptions standard() {
    return STANDARD;
  }

  private OdeOptions with(Consumer<OdeOptions> change) {
    OdeOptions copy = new OdeOptions(this);
    change.accept(copy);
    copy.settings(cancelled).requireUsable();
    return copy;
  }

  /**
   * Sets the relative tolerance: the local error of y_i is held below max(rtol |y_i|, atol_i).
   *
   * @throws IllegalArgumentException if it is below 2.3e-14 or not below 1
   */
  public OdeOptions rtol(double tolerance) {
    return with(copy -> copy.relativeTolerance = tolerance);
  }

  /**
   * Sets the absolute tolerance, one for all components or one for each: where a component is
   * negligible.
   *
   * @throws IllegalArgumentException if none is given, or one is not positive and finite
   */
  public OdeOptions atol(double... tolerances) {
    List<Double> given = Arrays.stream(tolerances).boxed().toList();
    return with(copy -> copy.absoluteTolerance = given);
  }

  /** Sets the method. */
  public OdeOptions method(OdeMethod other) {
    return with(copy -> copy.method = other);
  }

  /** Sets what is done beyond the published programs; {@link Mode#STANDARD} unless set. */
  public OdeOptions accuracy(Mode mode) {
    return with(copy -> copy.accuracy = mode);
  }

  /**
   * Sets the largest step.
   *
   * @throws IllegalArgumentException if it is not positive
   */
  public OdeOptions maxStep(double size) {
    return with(copy -> copy.maxStep = size);
  }

  /**
   * Sets the first step tried; 0: the method's own choice.
   *
   * @throws IllegalArgumentException if it is negative or not finite
   */
  public OdeOptions initialStep(double size) {
    return with(copy -> copy.initialStep = size);
  }

  /**
   * Sets the highest order used; 0: the method's own highest.
   *
   * @throws IllegalArgumentException if it is not from 0 to 13
   */
  public OdeOptions maxOrder(int order) {
    return with(copy -> copy.maxOrder = order);
  }

  /**
   * Sets how many steps may be tried, rejected ones included, before the integration fails.
   *
   * @throws IllegalArgumentException if it is not positive
   */
  public OdeOptions maxSteps(long count) {
    return with(copy -> copy.maxSteps = count);
  }

  /**
   * Sets whether all steps are kept, so that {@link OdeSolution#at} knows the whole interval: about
   * (k + 2) n numbers for a step of order k. Without them a run of any length needs no more memory
   * than its events.
   */
  public OdeOptions keepSteps(boolean keep) {
    return with(copy -> copy.keepSteps = keep);
  }

  /** Makes an integration that fails return what it has, instead of throwing an exception. */
  public OdeOptions returnFailures() {
    return with(copy -> copy.returnFailures = true);
  }

  /**
   * Searches the steps for jumps, pulses and poles of the equations that nobody has declared, as
   * {@link UndeclaredJumps} does: for equations of which nothing is known but their values. What is
   * known is better declared, by {@link OdeProblem#withBreakpoints} or an event.
   */
  public OdeOptions searchUndeclaredJumps() {
    return with(copy -> copy.searchUndeclaredJumps = true);
  }

  /**
   * Sets the cancel signal, such as {@code AtomicBoolean::get}, asked before every evaluation: the
   * integration ends within one evaluation after it is given, by whatever thread.
   */
  public OdeOptions cancelWhen(BooleanSupplier signal) {
    return with(copy -> copy.cancelled = signal);
  }

  /** Adds an event. */
  public OdeOptions event(OdeEvent event) {
    Objects.requireNonNull(event, "an event is null; build one by OdeEvent.when(...)");
    return with(copy -> copy.events = appended(events, event));
  }

  /** Adds a receiver of each accepted step. */
  public OdeOptions onStep(StepHandler handler) {
    return with(copy -> copy.stepHandlers = appended(stepHandlers, handler));
  }

  /**
   * Adds a receiver of the solution at given times, in the course of the integration.
   *
   * @param times in the order of integration, from its start to its end
   */
  public OdeOptions output(double[] times, OutputHandler handler) {
    RequestedTimes.Request request = new RequestedTimes.Request(times.clone(), 0, handler);
    return with(copy -> copy.outputs = appended(outputs, request));
  }

  /**
   * Adds a receiver of the solution at equal distances, from the start on.
   *
   * @throws IllegalArgumentException if the distance is not positive and finite
   */
  public OdeOptions outputEvery(double distance, OutputHandler handler) {
    if (!(distance > 0) || !Double.isFinite(distance)) {
      throw new IllegalArgumentException(
          "the distance of output times is " + distance + "; it must be positive and finite");
    }
    RequestedTimes.Request request = new RequestedTimes.Request(new double[0], distance, handler);
    return with(copy -> copy.outputs = appended(outputs, request));
  }

  /**
   * Sets the receiver of a checkpoint after a number of accepted steps.
   *
   * @throws IllegalArgumentException if the count is not positive
   */
  public OdeOptions checkpointEvery(long steps, Consumer<OdeCheckpoint> handler) {
    if (steps < 1) {
      throw new IllegalArgumentException(
          "the number of steps between checkpoints is " + steps + "; it must be at least 1");
    }
    return with(
        copy -> {
          copy.checkpointDistance = steps;
          copy.checkpointHandler = Optional.of(handler);
        });
  }

  private static <T> List<T> appended(List<T> some, T another) {
    List<T> more = new ArrayList<>(some);
    more.add(another);
    return List.copyOf(more);
  }

  OdeMethod method() {
    return method;
  }

  boolean keepsSteps() {
    return keepSteps;
  }

  boolean returnsFailures() {
    return returnFailures;
  }

  boolean searchesUndeclaredJumps() {
    return searchUndeclaredJumps;
  }

  BooleanSupplier cancelled() {
    return cancelled;
  }

  double relativeTolerance() {
    return relativeTolerance;
  }

  List<OdeEvent> events() {
    return events;
  }

  List<StepHandler> stepHandlers() {
    return stepHandlers;
  }

  List<RequestedTimes.Request> outputs() {
    return outputs;
  }

  long checkpointDistance() {
    return checkpointDistance;
  }

  Optional<Consumer<OdeCheckpoint>> checkpointHandler() {
    return checkpointHandler;
  }

  long maxSteps() {
    return maxSteps;
  }

  /** Returns what the integrators take. */
  IntegratorSettings settings(BooleanSupplier stop) {
    return new IntegratorSettings(
        relativeTolerance,
        absoluteTolerance,
        maxStep,
        initialStep,
        maxOrder,
        maxSteps,
        stop,
        accuracy);
  }
}
