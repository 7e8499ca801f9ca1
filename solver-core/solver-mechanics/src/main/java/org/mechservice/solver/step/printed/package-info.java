/**
 * The methods of the steps of {@code solver.step}, printed from their equations.
 *
 * <p>{@code PrintedSteps} makes an instance of each kind; nothing here is edited.
 */
package org.mechservice.solver.step.printed;
