/** Programs as students write them; outside the framework's packages, so that their lines are found. */
@org.jspecify.annotations.NullMarked
package student;
