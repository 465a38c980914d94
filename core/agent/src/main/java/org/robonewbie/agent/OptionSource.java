package org.robonewbie.agent;

import java.util.EnumMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Sources of options, in ascending order of precedence. */
enum OptionSource {
    PROGRAM("in the program"),
    ENVIRONMENT("in the environment"),
    FILE("in robonewbie.properties"),
    ARGUMENTS("on the command line");

    private final String where;

    OptionSource(String where) {
        this.where = where;
    }

    /** Value of an option and the precedence of its source. */
    record Value(String text, int strength) {}

    static Map<Option, Value> ofEnvironment(Map<String, String> environment) {
        Map<Option, Value> values = new EnumMap<>(Option.class);
        for (Option option : Option.values()) {
            String text = environment.get(option.variable());
            if (text != null) {
                values.put(option, ENVIRONMENT.value(option, text));
            }
        }
        return values;
    }

    static Map<Option, Value> ofProperties(Map<String, String> properties) {
        Map<Option, Value> values = new EnumMap<>(Option.class);
        properties.forEach((key, text) -> {
            Option option = find(key, FILE.where);
            values.put(option, FILE.value(option, text));
        });
        return values;
    }

    /** Reads {@code --name value}, {@code --name=value} and flags; other arguments are added to {@code others}. */
    static Map<Option, Value> ofArguments(List<String> args, List<String> others) {
        Map<Option, Value> values = new EnumMap<>(Option.class);
        Iterator<String> rest = args.iterator();
        while (rest.hasNext()) {
            String argument = rest.next();
            if (argument.equals("-h")) {
                values.put(Option.HELP, ARGUMENTS.value(Option.HELP, "true"));
            } else if (argument.startsWith("-") && !Values.isNumber(argument)) {
                int equals = argument.indexOf('=');
                String name = equals < 0 ? argument : argument.substring(0, equals);
                Option option = find(name.replaceFirst("^--", ""), ARGUMENTS.where);
                String text = equals < 0 ? nextValue(option, rest) : argument.substring(equals + 1);
                values.put(option, ARGUMENTS.value(option, text));
            } else {
                others.add(argument);
            }
        }
        return values;
    }

    Value value(Option option, String text) {
        String trimmed = option.isFlag() && text.isBlank() ? "true" : text.trim();
        if (!option.valid().condition().test(trimmed)) {
            throw new StartUpException(option.argument() + " needs "
                    + option.valid().expected() + ", not \"" + trimmed + "\" (" + where + ").");
        }
        return new Value(trimmed, ordinal());
    }

    static Option find(String key, String where) {
        return Option.ofKey(key)
                .orElseThrow(() -> new StartUpException(
                        "The option \"" + key + "\" " + where + " is unknown." + Option.question(key)));
    }

    private static String nextValue(Option option, Iterator<String> rest) {
        if (option.isFlag()) {
            return "true";
        }
        if (!rest.hasNext()) {
            throw new StartUpException(option.argument() + " needs a value; see --help.");
        }
        return rest.next();
    }
}
