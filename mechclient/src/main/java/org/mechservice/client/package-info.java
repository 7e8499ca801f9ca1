/**
 * The client library: connect to a MechService, load a model, run it there or here, build JARs.
 *
 * <p>A program needs few types. {@link org.mechservice.client.MechConnection} connects to one or
 * several servers; {@link org.mechservice.client.MechSession} holds one model at a server and
 * prepares its runs; a {@link org.mechservice.client.HostedModel} runs one with many values of its
 * parameters, in several sessions that move when their hosts are lost; {@link
 * org.mechservice.client.SimulationOptions} holds the options that differ from the model's file.
 * Both kinds of runs are a {@link org.mechservice.client.run.PreparedRun}. Every error is a {@link
 * org.mechservice.client.failure.ServiceException}. {@link org.mechservice.client.jar.JarCache}
 * names the folder of fetched JARs. Results go to any {@code ResultSink}, for files to {@code
 * ResultFile} of package {@code solver.text}.
 *
 * <p>The packages below: {@code client.run} has the runs, {@code client.jar} the JARs and the class
 * loading of local runs, {@code client.failure} the calls and their errors. Types there that are
 * not named in their package's story as its interface are public only because Java has no wider
 * package; programs do not use them.
 *
 * <p>The library depends on the CORBA contract ({@code idl}), on {@code solver-api} and on {@code
 * mechreport}, whose page a {@link org.mechservice.client.RemoteModel} writes of the methods that a
 * {@link org.mechservice.client.SessionBuilds} has the server build. Parser, code generator and
 * solver stay at the server; a local run loads the server's solver from the fetched runtime JAR.
 * The names of the set-up times are those of Rodríguez et al. 2003.
 */
@NullMarked
package org.mechservice.client;

import org.jspecify.annotations.NullMarked;
