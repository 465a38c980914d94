package org.robonewbie.simulator.export;

import java.math.BigDecimal;
import java.math.MathContext;
import org.robonewbie.nao.Vector3;

/** Indented XML of elements and attributes. Names and values must not need escapes. */
final class XmlText {

    private static final MathContext DIGITS = new MathContext(12);

    private final StringBuilder text = new StringBuilder();
    private int depth;

    XmlText(String comment) {
        text.append("<!--\n").append(comment.indent(2)).append("-->\n");
    }

    /** Begins an element; the attributes are names and values by turns. */
    void begin(String name, Object... attributes) {
        tag(name, attributes).append(">\n");
        depth++;
    }

    void end(String name) {
        depth--;
        text.append("  ".repeat(depth)).append("</").append(name).append(">\n");
    }

    /** Adds an element without content; the attributes are names and values by turns. */
    void add(String name, Object... attributes) {
        tag(name, attributes).append("/>\n");
    }

    private StringBuilder tag(String name, Object... attributes) {
        text.append("  ".repeat(depth)).append('<').append(name);
        for (int i = 0; i < attributes.length; i += 2) {
            text.append(' ')
                    .append(attributes[i])
                    .append("=\"")
                    .append(written(attributes[i + 1]))
                    .append('"');
        }
        return text;
    }

    private static String written(Object value) {
        if (value instanceof Double number) {
            return number(number);
        }
        return value instanceof Vector3 vector ? numbers(vector.x(), vector.y(), vector.z()) : value.toString();
    }

    /** Returns numbers separated by spaces. */
    static String numbers(double... values) {
        StringBuilder numbers = new StringBuilder();
        for (double value : values) {
            numbers.append(numbers.isEmpty() ? "" : " ").append(number(value));
        }
        return numbers.toString();
    }

    private static String number(double value) {
        return new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString();
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
