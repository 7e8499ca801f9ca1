/**
 * Functional Mock-up Units: a model as a file that other simulators load, by FMI 2.0 and 3.0.
 *
 * <p>The equations come as C, one structure and a handful of functions ({@link
 * org.mechservice.sim.fmu.FmuModel}). This package adds what makes an FMU of them and writes the
 * file ({@link org.mechservice.sim.fmu.FmuArchive}):
 *
 * <pre>
 * modelDescription.xml        variables, units, structure, what the unit can do
 * sources/                    the model's C; instance, integrator and interface from the resources
 * binaries/PLATFORM/          the same, compiled here: by cc, or by zig for other machines
 * </pre>
 *
 * <p>Both kinds are in one file. In Model Exchange the importer integrates; event functions are its
 * event indicators, and after a completed step that has left the constraints the unit asks for an
 * event, in which it projects the state back. In Co-Simulation the unit integrates by the Adams
 * method of {@code org.mechservice.solver.ode.adams}, written once more in C, and projects every
 * step. {@code mech_watch.c} then searches the step for what its ends do not show, by the decisions
 * of {@code solver.dynamics.event.StepSearch}. A unit allocates nothing after it was instantiated,
 * and refuses wrong orders of calls, wrong value references and values that are not finite with an
 * error and a message.
 *
 * <p>{@code IndependentCoordinates} chooses states of closed loops that determine all others, which
 * {@code mech_independent.c} then computes at every evaluation.
 *
 * <p>{@link org.mechservice.sim.fmu.WebAssemblyModule} compiles the same sources, without the
 * interface of FMI, to a module that browsers run.
 *
 * <p>Value references follow the layout that {@link org.mechservice.sim.fmu.ValueReferences} and
 * {@code mech_fmu.h} state. The bytes of an FMU of sources depend only on the model: entries in
 * order of their names, one date, and a token that is the hash of its content.
 */
@NullMarked
package org.mechservice.sim.fmu;

import org.jspecify.annotations.NullMarked;
