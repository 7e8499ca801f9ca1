/**
 * Reading, generating and building the models of clients, outside the process of the host.
 *
 * <p>{@link org.mechservice.sim.service.setup.SetUps} are the operations; each is a function of the
 * {@link org.mechservice.sim.service.setup.ModelFiles} and options that it is given. {@link
 * org.mechservice.sim.service.setup.SetUpsHere} carries them out with the models of package {@code
 * library}. {@link org.mechservice.sim.service.setup.SetUpWorkers} hands them to processes with
 * bounded memory and time, which stay warm, and ends a process whose client has gone; in an
 * embedded server, which serves nobody else, it carries them out itself. {@code SetUpMain} is the
 * main class of a process. A {@code SetUpCall} travels on its standard input and output as {@code
 * PlainValues}, which are read by the declared types of the operations.
 *
 * <p>Depends on the packages {@code library}, {@code limits} and {@code contract}, on mechguard and
 * on mechsim-codegen.
 */
@NullMarked
package org.mechservice.sim.service.setup;

import org.jspecify.annotations.NullMarked;
