/** The shared benchmark scenes and their reference solutions, read from their JSON form. */
package org.mechservice.solver.scenes;
