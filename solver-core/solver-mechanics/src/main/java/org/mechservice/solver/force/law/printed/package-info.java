/**
 * The methods of the force laws of {@code force.law}, printed from their formulas.
 * {@code PrintedLaws} makes an instance of each; the other classes are not edited.
 */
package org.mechservice.solver.force.law.printed;
