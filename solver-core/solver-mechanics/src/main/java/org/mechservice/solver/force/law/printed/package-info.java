/**
 * The methods of the force laws of {@code force.law}, printed from their formulas.
 *
 * <p>{@code PrintedLaws} makes an instance of each; nothing here is edited.
 */
package org.mechservice.solver.force.law.printed;
