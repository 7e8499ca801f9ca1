/**
 * Mechanisms in the coordinates of all their bodies, dense and slow, with the equations of joints
 * and closures written straight from docs/mechml.md#joints and docs/mechml.md#constraints and
 * differentiated by Taylor arithmetic. It knows the descriptions and shares nothing with what it is
 * held against.
 */
package org.mechservice.solver.oracle;
