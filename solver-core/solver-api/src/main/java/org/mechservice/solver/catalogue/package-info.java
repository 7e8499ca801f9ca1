/**
 * The closed lists that every part of the product shares, each written once: {@link
 * org.mechservice.solver.catalogue.MessageCode} has all messages with their severity and page,
 * {@link org.mechservice.solver.catalogue.Formulation} the formulations, {@link
 * org.mechservice.solver.catalogue.ClosureMethod} the closure methods and {@link
 * org.mechservice.solver.catalogue.IntegrationMethod} the integrators, with the properties on which
 * other packages base decisions.
 *
 * <p>Each list is an enum. Entries are text only in external formats: in MechML, on the command
 * line, in CORBA, JSON and manifests. The enum itself reads and writes this text and rejects an
 * unknown name with a message that lists the known ones.
 *
 * <p>The enums do not refer to the classes of the methods that they name: a standalone JAR contains
 * the enums, but only the integrators and formulations that its scene uses. The package depends on
 * no other.
 */
package org.mechservice.solver.catalogue;
