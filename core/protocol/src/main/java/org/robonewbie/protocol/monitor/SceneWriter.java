package org.robonewbie.protocol.monitor;

import java.util.List;
import org.robonewbie.protocol.monitor.LightNode.Colour;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * Writes the scene of a monitor message: the full tree, or only what has changed since it was last sent.
 *
 * <p>Source of the format: SimSpark's {@code sparkmonitor.cpp} as recorded from rcssserver3d 0.7.3.
 */
final class SceneWriter {

    /** Change in a matrix element above which a transform is sent again. */
    static final float THRESHOLD = 0.005f;

    private final SexpWriter out;

    SceneWriter(SexpWriter out) {
        this.out = out;
    }

    /** Writes the full tree. If {@code toAll} is true, later partial messages are relative to this one. */
    void writeFull(List<? extends SceneNode> nodes, boolean toAll) {
        out.text("(");
        writeFullNodes(nodes, toAll);
        out.text(")");
    }

    /** Writes the tree without the contents of unchanged nodes. */
    void writePartial(List<? extends SceneNode> nodes) {
        out.text("(");
        writePartialNodes(nodes);
        out.text(")");
    }

    private void writeFullNodes(List<? extends SceneNode> nodes, boolean toAll) {
        for (SceneNode node : nodes) {
            if (node instanceof TransformNode transform) {
                writeFullTransform(transform, toAll);
            } else if (node instanceof MeshNode mesh) {
                writeFullMesh(mesh);
            } else if (node instanceof LightNode light) {
                writeLight(light);
            }
        }
    }

    private void writeFullTransform(TransformNode transform, boolean toAll) {
        out.text("(nd TRF");
        writeMatrix(transform);
        if (toAll) {
            transform.markSent();
        }
        writeFullNodes(transform.children(), toAll);
        out.text(")");
    }

    private void writeMatrix(TransformNode transform) {
        out.text(" (SLT");
        for (int i = 0; i < 16; i++) {
            out.text(" ").general(transform.element(i));
        }
        out.text(")");
    }

    private void writeLight(LightNode light) {
        out.text("(nd Light");
        writeColour("setDiffuse", light.diffuse());
        writeColour("setAmbient", light.ambient());
        writeColour("setSpecular", light.specular());
        out.text(")");
    }

    private void writeColour(String name, Colour colour) {
        out.text(" (").text(name);
        out.text(" ").general(colour.red());
        out.text(" ").general(colour.green());
        out.text(" ").general(colour.blue());
        out.text(" ").general(colour.alpha()).text(")");
    }

    private void writeFullMesh(MeshNode mesh) {
        out.text("(nd ").text(kind(mesh));
        writeVisibility(mesh);
        if (mesh.isTransparent()) {
            out.text(" (setTransparent)");
        }
        out.text(" (load ").text(mesh.form().name());
        writeWords(mesh.form().parameters());
        out.text(") (sSc ").general(mesh.scaleX());
        out.text(" ").general(mesh.scaleY());
        out.text(" ").general(mesh.scaleZ()).text(")");
        writeMaterials(mesh);
        out.text(")");
    }

    private void writeVisibility(MeshNode mesh) {
        out.text(mesh.isVisible() ? " (setVisible 1)" : " (setVisible 0)");
    }

    private void writeMaterials(MeshNode mesh) {
        if (mesh.materials().isEmpty()) {
            return;
        }
        out.text(mesh.form() instanceof MeshNode.MeshFile ? "(resetMaterials" : " (sMat");
        writeWords(mesh.materials());
        out.text(")");
    }

    private void writeWords(List<String> words) {
        for (String word : words) {
            out.text(" ").text(word);
        }
    }

    private void writePartialNodes(List<? extends SceneNode> nodes) {
        for (SceneNode node : nodes) {
            if (node instanceof TransformNode transform) {
                writePartialTransform(transform);
            } else if (node instanceof MeshNode mesh) {
                writePartialMesh(mesh);
            } else {
                out.text("(nd)");
            }
        }
    }

    private void writePartialTransform(TransformNode transform) {
        out.text("(nd");
        if (transform.hasChangedBeyond(THRESHOLD)) {
            writeMatrix(transform);
            transform.markSent();
        }
        writePartialNodes(transform.children());
        out.text(")");
    }

    private void writePartialMesh(MeshNode mesh) {
        out.text("(nd ").text(kind(mesh));
        if (mesh.takeVisibilityChange()) {
            writeVisibility(mesh);
        }
        out.text(")");
    }

    private static String kind(MeshNode mesh) {
        return mesh.form() instanceof MeshNode.MeshFile ? "StaticMesh" : "SMN";
    }
}
