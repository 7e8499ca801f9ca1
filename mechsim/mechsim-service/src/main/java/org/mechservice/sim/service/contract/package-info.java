/**
 * Between the service and its CORBA contract: values, errors and events in the contract's types.
 *
 * <p>{@link org.mechservice.sim.service.contract.ContractTypes} converts diagnostics, columns and
 * failures. {@link org.mechservice.sim.service.contract.ContractErrors} makes the contract's
 * exceptions with their codes, also from exceptions of the model builder.
 *
 * <p>Events take two ways. {@link org.mechservice.sim.service.contract.Journal} logs the events of
 * a host or a server and keeps them for administrators. {@link
 * org.mechservice.sim.service.contract.SessionEvents} keeps the events of one session for clients
 * that poll, and {@link org.mechservice.sim.service.contract.ClientNotifier} calls clients back.
 * All events are kept in an {@link org.mechservice.sim.service.contract.EventBuffer}.
 *
 * <p>{@link org.mechservice.sim.service.contract.AccessRights} says which role an operation of a
 * server or host requires, and {@link org.mechservice.sim.service.contract.OwnerGate} guards what
 * belongs to one user. {@link org.mechservice.sim.service.contract.DenialLog} records refusals.
 *
 * <p>Depends on the IDL stubs, mechml's diagnostics and the model builder's exceptions, on no other
 * package of the service.
 */
@NullMarked
package org.mechservice.sim.service.contract;

import org.jspecify.annotations.NullMarked;
