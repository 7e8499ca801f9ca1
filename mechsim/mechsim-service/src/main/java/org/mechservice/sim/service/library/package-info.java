/**
 * Models as sessions use them: read, requested with options, built once, kept.
 *
 * <p>A {@link org.mechservice.sim.service.library.LoadedModel} is a model file that was read. The
 * name-value pairs of a request become {@link org.mechservice.sim.service.library.RequestOptions}
 * and, with the settings of the file, one validated {@link
 * org.mechservice.sim.service.library.SimulationRequest}; it returns the generator's {@code
 * BuildOptions} and the solver's {@code RunSettings}. {@link
 * org.mechservice.sim.service.library.ModelLibrary} generates and compiles; {@code BoundedCache}
 * keeps the latest models. {@link org.mechservice.sim.service.library.ModelWarnings} finds what a
 * client should know before a run begins, {@link org.mechservice.sim.service.library.SetUpTimes}
 * adds up the set-up times of Rodríguez et al. 2003 (t1s, tcc, t2s), and {@link
 * org.mechservice.sim.service.library.ModelImport} translates URDF.
 *
 * <p>Depends on the packages {@code contract} and {@code limits}, on mechml and on mechsim-codegen.
 */
@NullMarked
package org.mechservice.sim.service.library;

import org.jspecify.annotations.NullMarked;
