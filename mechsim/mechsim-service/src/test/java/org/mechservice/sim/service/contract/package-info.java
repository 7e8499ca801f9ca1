@NullMarked
package org.mechservice.sim.service.contract;

import org.jspecify.annotations.NullMarked;
