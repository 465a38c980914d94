package org.robonewbie.app.hint;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.text.Spelling;

/**
 * Says what to do about a remark of the compiler: the import that is missing, the name of the framework that was probably meant, or what
 * mistakes of its kind need.
 */
public final class Hints {

    /** Such as {@code location: class org.robonewbie.nao.motion.Posture}. */
    private static final Pattern OWNER =
            Pattern.compile("symbol: +method[^\\n]*\\n.*\\b(?:class|interface|of type) (?:\\w+\\.)*(\\w+)");

    /** The compiler takes a class that it does not know for a package, if more than one name follows. */
    private static final Pattern TAKEN_FOR_PACKAGE = Pattern.compile("package ([A-Z]\\w*) does not exist");

    private final FrameworkNames names;

    /**
     * Prepares hints.
     *
     * @param names what can have been meant
     */
    public Hints(FrameworkNames names) {
        this.names = names;
    }

    /**
     * A remark of the compiler.
     *
     * @param code the compiler's name of the mistake
     * @param place what it has underlined
     * @param text what it says, in English
     */
    public record Remark(String code, String place, String text) {

        private boolean isUnknownName() {
            return code.contains("cant.resolve")
                    || code.contains("enum.label")
                    || TAKEN_FOR_PACKAGE.matcher(text).find();
        }

        private String lastName() {
            Matcher taken = TAKEN_FOR_PACKAGE.matcher(text);
            if (taken.find()) {
                return taken.group(1);
            }
            String name = place.substring(place.lastIndexOf('.') + 1).strip();
            return name.matches("\\w+") ? name : "";
        }
    }

    /**
     * Returns what to do.
     *
     * @param remark a remark of the compiler
     * @return a sentence or two; empty if nothing is to be added
     */
    public String of(Remark remark) {
        return missingImport(remark)
                .map(line -> "Add at the top of the file: " + line)
                .or(() -> meant(remark))
                .or(() -> offers(remark))
                .orElseGet(() -> BeginnersHints.of(remark.code(), remark.place()));
    }

    /**
     * Returns the line that is missing at the top of the file.
     *
     * @param remark a remark of the compiler
     * @return the line with the import; empty if the remark is about something else
     */
    public Optional<String> missingImport(Remark remark) {
        return remark.isUnknownName() ? names.importOf(remark.lastName()) : Optional.empty();
    }

    private Optional<String> meant(Remark remark) {
        String written = remark.lastName();
        if (written.isEmpty() || !remark.isUnknownName()) {
            return Optional.empty();
        }
        boolean constant = written.equals(written.toUpperCase(Locale.ROOT));
        boolean type = Character.isUpperCase(written.charAt(0)) && !constant;
        return Optional.of(Spelling.question(
                        written,
                        constant ? names.constants() : type ? names.types().keySet() : names.methodsOf(owner(remark))))
                .map(String::strip)
                .filter(question -> !question.isEmpty());
    }

    /** What can be called where nothing similar to the written name is. */
    private Optional<String> offers(Remark remark) {
        Optional<String> owner = remark.isUnknownName() ? owner(remark) : Optional.empty();
        return owner.map(type -> type + " has the methods " + String.join(", ", names.methodsOf(owner)) + ".");
    }

    /** The class of the framework in which the compiler has looked for a method; only its own can be meant. */
    private Optional<String> owner(Remark remark) {
        Matcher place = OWNER.matcher(remark.text());
        return place.find() ? Optional.of(place.group(1)).filter(names.types()::containsKey) : Optional.empty();
    }
}
