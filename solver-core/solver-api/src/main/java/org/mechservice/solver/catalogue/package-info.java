/**
 * The closed lists that every part of the product shares, each written once: {@link
 * org.mechservice.solver.catalogue.MessageCode} has all messages with their severity and page,
 * {@link org.mechservice.solver.catalogue.Formulation} the formulations, {@link
 * org.mechservice.solver.catalogue.ClosureMethod} the ways to close loops and {@link
 * org.mechservice.solver.catalogue.IntegrationMethod} the integrators, with the facts about them
 * that others decide by.
 *
 * <p>A list is an enum. Text stands for an entry only at a border: in MechML, on the command line,
 * in CORBA, JSON and manifests. There it is read and written by the enum itself, which refuses an
 * unknown name with a message that lists the known ones.
 *
 * <p>The enums refer to no class that does the work they name: a standalone JAR carries them, and
 * must not carry the integrators and formulations its scene does not use. The package depends on
 * nothing.
 */
package org.mechservice.solver.catalogue;
