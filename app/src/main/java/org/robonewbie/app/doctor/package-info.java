/** The checks of the installation. Start in {@link org.robonewbie.app.doctor.Checkup}. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.doctor;
