package org.robonewbie.programs.hint;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
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

    /** A class or all of a package, with the package, as they stand in a line that imports them. */
    private static final Pattern IMPORTED = Pattern.compile("((?:[a-z_]\\w*\\.)+)([A-Z]\\w*|\\*)");

    private static final Pattern UNKNOWN_PACKAGE = Pattern.compile("package ([a-z_]\\w*(?:\\.\\w+)*) does not exist");
    private static final Pattern IN_PACKAGE = Pattern.compile("location: +package ");

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

        /** Whether it is about a name that is written with its package, as in a line that imports it. */
        private boolean isAboutImport() {
            Matcher unknown = UNKNOWN_PACKAGE.matcher(text);
            boolean noPackage = unknown.find();
            return (IMPORTED.matcher(imported()).matches()
                            && (noPackage || IN_PACKAGE.matcher(text).find()))
                    || (noPackage && unknown.group(1).contains(".") && isWholePackage());
        }

        /** In a line that imports all of a package nothing of it is underlined. */
        private boolean isWholePackage() {
            return !place.contains(".");
        }

        /** What is underlined, without blanks around it. */
        private String imported() {
            return place.strip();
        }

        /** The compiler takes a variable that it does not know for a package, too. */
        private boolean isUnknownVariable() {
            return UNKNOWN_PACKAGE.matcher(text).find() && !isAboutImport();
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
        return meantImport(remark)
                .or(() -> missingImport(remark).map(line -> "Add at the top of the file: " + line))
                .or(() -> meant(remark))
                .or(() -> offers(remark))
                .orElseGet(() ->
                        BeginnersHints.of(remark.isUnknownVariable() ? "cant.resolve" : remark.code(), remark.place()));
    }

    /**
     * Returns the line that is missing at the top of the file.
     *
     * @param remark a remark of the compiler
     * @return the line with the import; empty if the remark is about something else
     */
    public Optional<String> missingImport(Remark remark) {
        return remark.isUnknownName() && !remark.isAboutImport() ? names.importOf(remark.lastName()) : Optional.empty();
    }

    /**
     * Leaves out what only follows from imports that are missing or misspelt: each later line that uses one of these names is a mistake
     * to the compiler, too.
     *
     * @param all what the compiler has said, in its order
     * @param remark takes one of them as a remark
     * @param <R> what the compiler's words come in
     * @return those about imports, each once; all of them if none is about imports
     */
    public <R> List<R> withoutFollowUps(List<R> all, Function<? super R, Remark> remark) {
        List<R> aboutImports = new ArrayList<>();
        Set<String> named = new HashSet<>();
        for (R each : all) {
            Remark said = remark.apply(each);
            if (said.isAboutImport()) {
                named.add(said.lastName());
                aboutImports.add(each);
            }
        }
        for (R each : all) {
            Remark said = remark.apply(each);
            if (missingImport(said).isPresent() && named.add(said.lastName())) {
                aboutImports.add(each);
            }
        }
        return aboutImports.isEmpty() ? all : aboutImports;
    }

    /** What a misspelt import is meant to be: the package in which the class is, or one with a similar name. */
    private Optional<String> meantImport(Remark remark) {
        if (!remark.isAboutImport()) {
            return Optional.empty();
        }
        String written = remark.imported();
        Matcher unknown = UNKNOWN_PACKAGE.matcher(remark.text());
        Optional<String> meant = Optional.ofNullable(names.types().get(remark.lastName()));
        if (meant.isEmpty() && unknown.find()) {
            String home = unknown.group(1);
            meant = Spelling.nearest(home, FrameworkNames.PACKAGES)
                    .map(near -> near + (remark.isWholePackage() ? ".*" : written.substring(home.length())));
        }
        return meant.map(name -> "Did you mean " + name + "?");
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
