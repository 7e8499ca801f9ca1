/**
 * {@code mech optimise} and {@code mech identify}: parameters for which a model does best, or
 * agrees best with measurements; and {@code mech gradient}, derivatives of results by parameters.
 *
 * <p>{@link org.mechservice.cli.optimise.VariableOptions} reads which parameters may be changed
 * between which bounds, in both commands; {@link org.mechservice.cli.optimise.OptimiseCommand} and
 * {@link org.mechservice.cli.optimise.IdentifyCommand} have {@code org.mechservice.study} do the
 * work, print the answer as text or JSON, and write reports as pages with pictures.
 */
@NullMarked
package org.mechservice.cli.optimise;

import org.jspecify.annotations.NullMarked;
