/**
 * The same model with many values of its parameters, over all hosts of a server.
 *
 * <p>{@link org.mechservice.client.sweep.Sweep} is the main type. It runs a model at every point of
 * a {@link org.mechservice.client.sweep.SweepGrid}, which combines the values of several {@link
 * org.mechservice.client.sweep.SweptParameter}s. One thread per place of the server runs points
 * with a {@code PointRunner}, each in its own session; the number of threads grows with the number
 * of places. A {@link org.mechservice.client.sweep.SweepListener} receives one {@link
 * org.mechservice.client.sweep.SweepRow} per finished point: its outcome, the last row of its
 * results and its report.
 *
 * <p>Each run has the same bits as a single run with these values. A run that is lost with its host
 * or with the connection is repeated on another host. A run that fails numerically is a row with
 * the reason. The sweep ends early if the model has no parameter of a given name ({@link
 * org.mechservice.client.sweep.UnknownParameterException}), or if no host is left.
 *
 * <p>The package depends on {@code client} and {@code client.run}. The command {@code mech sweep}
 * writes its rows to a file and can resume an interrupted sweep from it.
 */
@NullMarked
package org.mechservice.client.sweep;

import org.jspecify.annotations.NullMarked;
