/**
 * Calls to the server and their errors.
 *
 * <p>{@link org.mechservice.client.failure.ServiceException} is the sealed base of ten exceptions;
 * each has a code of the error catalogue and one message. Nine are refusals, with the text of the
 * server or of this client; {@link org.mechservice.client.failure.ServerLostException} means that
 * the server cannot be reached. {@link org.mechservice.client.failure.InvalidModelException}
 * carries a {@link org.mechservice.client.failure.ModelMessage} for every place in the model's
 * file, {@link org.mechservice.client.failure.InvalidStateException} the {@link
 * org.mechservice.client.failure.RunState} that did not allow the call.
 *
 * <p>{@code RemoteCalls} makes every call of the library. It translates the exceptions of CORBA and
 * of the contract into these types, and repeats calls that may be made twice when the connection is
 * cut. Programs do not use it.
 *
 * <p>The package depends only on the contract; all other packages of the library depend on it.
 */
@NullMarked
package org.mechservice.client.failure;

import org.jspecify.annotations.NullMarked;
