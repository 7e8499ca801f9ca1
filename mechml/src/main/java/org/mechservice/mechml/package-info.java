/**
 * What a MechML file says, as values that never change: the model, its simulations, its parameters.
 *
 * <p>{@link org.mechservice.mechml.MechmlModel} is the main type. It holds the mechanism in SI
 * units, the {@link org.mechservice.mechml.SimulationSettings} of every simulation block with the
 * {@link org.mechservice.mechml.SimulationTask} of each, the {@link
 * org.mechservice.solver.api.ModelParameter}s and the warnings. {@link
 * org.mechservice.mechml.ReadOptions} choose a simulation and set parameters before the file is
 * read.
 *
 * <p>{@code org.mechservice.mechml.resolve.MechmlReader} makes a model from the bytes of a file.
 * The packages stand in this order, and each one depends only on those before it: {@code diagnosis}
 * and {@code unit}, {@code document} and {@code expression}, this one, {@code resolve}, {@code
 * urdf}.
 *
 * <p>The language is defined in docs/mechml.md and mechml.dtd. The types of the mechanism come from
 * solver-mechanics.
 */
@NullMarked
package org.mechservice.mechml;

import org.jspecify.annotations.NullMarked;
