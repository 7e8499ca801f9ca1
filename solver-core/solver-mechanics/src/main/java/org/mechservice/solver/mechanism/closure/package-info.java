/**
 * What closes the loops of a mechanism: joints that were cut, constant distances with or without a
 * rod's mass, couplings of coordinates, points on planes and lines. Immutable descriptions; package
 * {@code org.mechservice.solver.closure} computes with them.
 */
package org.mechservice.solver.mechanism.closure;
