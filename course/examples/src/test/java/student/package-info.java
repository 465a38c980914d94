/** Programs with mistakes, as students write them. */
@org.jspecify.annotations.NullMarked
package student;
