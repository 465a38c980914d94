package org.robonewbie.pagejvm;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Method descriptor such as {@code (ILjava/lang/String;)V}.
 *
 * @param parameters descriptors of the parameters
 * @param result descriptor of the result
 */
record Descriptor(List<String> parameters, String result) {

    private static final Map<String, Descriptor> KNOWN = new HashMap<>();

    static Descriptor of(String text) {
        return KNOWN.computeIfAbsent(text, Descriptor::parse);
    }

    private static Descriptor parse(String text) {
        List<String> parameters = new ArrayList<>();
        int at = 1;
        while (text.charAt(at) != ')') {
            int end = endOfType(text, at);
            parameters.add(text.substring(at, end));
            at = end;
        }
        return new Descriptor(List.copyOf(parameters), text.substring(at + 1));
    }

    private static int endOfType(String text, int begin) {
        int at = begin;
        while (text.charAt(at) == '[') {
            at++;
        }
        return text.charAt(at) == 'L' ? text.indexOf(';', at) + 1 : at + 1;
    }

    /** {@return the default value for a variable of a type} */
    static @org.jspecify.annotations.Nullable Object zero(String type) {
        return switch (type) {
            case "Z", "B", "C", "S", "I" -> 0;
            case "J" -> 0L;
            case "F" -> 0f;
            case "D" -> 0.0;
            default -> null;
        };
    }

    /** {@return whether a value of this type takes two local variables} */
    static boolean isWide(String type) {
        return type.equals("J") || type.equals("D");
    }
}
