package org.robonewbie.web.compiler;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import javax.lang.model.element.Element;
import javax.lang.model.element.ElementKind;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.TypeElement;
import javax.lang.model.util.Elements;
import org.robonewbie.programs.hint.FrameworkNames;

/** Collects names from RoboNewbie's classes, to be suggested in place of misspelt ones. */
final class NamesOfTheLibrary {

    private final Elements elements;
    private final Map<String, String> types = new TreeMap<>();
    private final List<String> constants = new ArrayList<>();
    private final Map<String, SortedSet<String>> methods = new TreeMap<>();

    private NamesOfTheLibrary(Elements elements) {
        this.elements = elements;
    }

    /**
     * Reads the names.
     *
     * @param elements gives access to the classes that the compiler knows
     * @return the names
     */
    static FrameworkNames read(Elements elements) {
        NamesOfTheLibrary names = new NamesOfTheLibrary(elements);
        for (String name : FrameworkNames.TYPES) {
            TypeElement type = elements.getTypeElement(name);
            if (type != null) {
                names.add(type);
            }
        }
        return new FrameworkNames(names.types, names.constants, names.methods);
    }

    private void add(TypeElement type) {
        String name = type.getSimpleName().toString();
        types.put(name, type.getQualifiedName().toString());
        methods.put(name, new TreeSet<>());
        for (Element member : elements.getAllMembers(type)) {
            String memberName = member.getSimpleName().toString();
            if (member.getKind() == ElementKind.ENUM_CONSTANT) {
                constants.add(memberName);
            } else if (isMeant(member)) {
                methods.get(name).add(memberName);
            }
        }
    }

    private static boolean isMeant(Element member) {
        return member.getKind() == ElementKind.METHOD
                && member.getModifiers().contains(Modifier.PUBLIC)
                && FrameworkNames.isMeant(
                        member.getSimpleName().toString(),
                        member.getEnclosingElement().toString());
    }
}
