package org.mechservice.mechml.resolve.body;

import org.mechservice.mechml.Solid;

/**
 * A solid of a body with its mass.
 *
 * @param solid its shape and place
 * @param properties its mass, centre and inertia
 */
record WeighedSolid(Solid solid, MassProperties properties) {}
