/** Long runs in which agents and monitors do what they can against a server. Read {@link org.robonewbie.app.soak.SoakTest} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.soak;
