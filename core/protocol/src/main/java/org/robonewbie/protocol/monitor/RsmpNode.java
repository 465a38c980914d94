package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.nao.kinematics.Pose;

/**
 * A node of RSMP's scene graph: a description ({@code DSC}), a transform relative to its parent ({@code TRF}) or a mesh ({@code
 * SMN}).
 */
final class RsmpNode {

    private final List<List<String>> descriptions = new ArrayList<>();
    private final List<RsmpNode> children = new ArrayList<>();
    private Optional<Pose> pose = Optional.empty();
    private Optional<MeshNode> mesh = Optional.empty();

    void describe(List<String> words) {
        descriptions.add(List.copyOf(words));
    }

    void add(RsmpNode child) {
        children.add(child);
    }

    void draw(MeshNode shape) {
        mesh = Optional.of(shape);
    }

    void moveTo(Pose newPose) {
        pose = Optional.of(newPose);
    }

    /** Returns the words of {@code DSC}, such as {@code agent Blue 2}; empty for other kinds of nodes. */
    List<List<String>> descriptions() {
        return Collections.unmodifiableList(descriptions);
    }

    List<RsmpNode> children() {
        return Collections.unmodifiableList(children);
    }

    /** Returns the child nodes that are transforms. */
    List<RsmpNode> transforms() {
        return children.stream().filter(RsmpNode::isTransform).toList();
    }

    boolean isTransform() {
        return pose.isPresent();
    }

    /** Returns the pose relative to the parent. */
    Pose pose() {
        return pose.orElse(Pose.ORIGIN);
    }

    Optional<MeshNode> mesh() {
        return mesh;
    }

    /** Returns all meshes in this subtree. */
    Stream<MeshNode> meshes() {
        return Stream.concat(mesh.stream(), children.stream().flatMap(RsmpNode::meshes));
    }

    /** Returns whether another tree consists of the same nodes, at whatever poses. */
    boolean isBuiltLike(RsmpNode other) {
        boolean same = children.size() == other.children.size()
                && isTransform() == other.isTransform()
                && mesh.map(MeshNode::form).equals(other.mesh.map(MeshNode::form));
        for (int i = 0; same && i < children.size(); i++) {
            same = children.get(i).isBuiltLike(other.children.get(i));
        }
        return same;
    }
}
