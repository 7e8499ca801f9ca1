@NullMarked
package org.mechservice.sim.service.results;

import org.jspecify.annotations.NullMarked;
