@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.league;
