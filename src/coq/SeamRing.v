(* SPDX-License-Identifier: GPL-3.0-or-later *)

(* What the files written by `seamproof export --coq` are proven with: rings in which Coq
   computes, each with a theorem that says what its elements are as real numbers. The theorems
   at the end, `zero_holds`, `number_holds` and `sign_holds`, turn a computation that ends in
   `true` into a statement about Coq's own R. *)

From Coq Require Import Reals QArith Qreals List Bool Arith Lia Lra.
Import ListNotations.
Local Open Scope R_scope.

(* ---- Formulas: the statement is convertible to `eval` of one ---- *)

Inductive expr :=
| Num (z : Z) | Frac (z : Z) (d : positive) | Sym (i : nat)
| Add (a b : expr) | Sub (a b : expr) | Mul (a b : expr) | Opp (a : expr) | Pow (a : expr) (n : nat).

Fixpoint eval (env : list R) (e : expr) : R :=
  match e with
  | Num z => IZR z
  | Frac z d => IZR z / IZR (Zpos d)
  | Sym i => nth i env 0
  | Add a b => eval env a + eval env b
  | Sub a b => eval env a - eval env b
  | Mul a b => eval env a * eval env b
  | Opp a => - eval env a
  | Pow a n => eval env a ^ n
  end.

(* Values named in order, each by a formula in those before it. *)
Fixpoint defined (env : list R) (defs : list expr) (values : list R) : Prop :=
  match defs, values with
  | [], [] => True
  | d :: defs, x :: values => x = eval env d /\ defined (env ++ [x]) defs values
  | _, _ => False
  end.

(* ---- Intervals with rational ends; None is the whole line ---- *)

Definition interval := option (Q * Q).

Definition within (i : interval) (x : R) : Prop :=
  match i with None => True | Some (l, h) => Q2R l <= x <= Q2R h end.

Definition qmin (a b : Q) := if Qle_bool a b then a else b.
Definition qmax (a b : Q) := if Qle_bool a b then b else a.

Lemma qmin_le a b : Q2R (qmin a b) <= Q2R a /\ Q2R (qmin a b) <= Q2R b.
Proof.
  unfold qmin. destruct (Qle_bool a b) eqn:E.
  - apply Qle_bool_iff, Qle_Rle in E. lra.
  - assert (H : ~ (a <= b)%Q) by (rewrite <- Qle_bool_iff; congruence).
    apply Qnot_le_lt, Qlt_Rlt in H. lra.
Qed.

Lemma qmax_ge a b : Q2R a <= Q2R (qmax a b) /\ Q2R b <= Q2R (qmax a b).
Proof.
  unfold qmax. destruct (Qle_bool a b) eqn:E.
  - apply Qle_bool_iff, Qle_Rle in E. lra.
  - assert (H : ~ (a <= b)%Q) by (rewrite <- Qle_bool_iff; congruence).
    apply Qnot_le_lt, Qlt_Rlt in H. lra.
Qed.

Definition iadd (i j : interval) : interval :=
  match i, j with
  | Some (a, b), Some (c, d) => Some (a + c, b + d)%Q
  | _, _ => None
  end.

Definition imul (i j : interval) : interval :=
  match i, j with
  | Some (a, b), Some (c, d) =>
      let p := (a * c)%Q in let q := (a * d)%Q in let r := (b * c)%Q in let s := (b * d)%Q in
      Some (qmin (qmin p q) (qmin r s), qmax (qmax p q) (qmax r s))
  | _, _ => None
  end.

Lemma iadd_within i j x y : within i x -> within j y -> within (iadd i j) (x + y).
Proof.
  destruct i as [[a b]|], j as [[c d]|]; simpl; auto. rewrite !Q2R_plus. lra.
Qed.

Lemma between l h x y : l <= x <= h ->
  (l * y <= x * y \/ h * y <= x * y) /\ (x * y <= l * y \/ x * y <= h * y).
Proof. intros H. destruct (Rle_dec 0 y); split; [left|right|right|left]; nra. Qed.

Lemma imul_within i j x y : within i x -> within j y -> within (imul i j) (x * y).
Proof.
  destruct i as [[a b]|], j as [[c d]|]; simpl; auto. intros Hx Hy.
  set (p := (a * c)%Q). set (q := (a * d)%Q). set (r := (b * c)%Q). set (s := (b * d)%Q).
  assert (Ep : Q2R p = Q2R a * Q2R c) by (unfold p; apply Q2R_mult).
  assert (Eq : Q2R q = Q2R a * Q2R d) by (unfold q; apply Q2R_mult).
  assert (Er : Q2R r = Q2R b * Q2R c) by (unfold r; apply Q2R_mult).
  assert (Es : Q2R s = Q2R b * Q2R d) by (unfold s; apply Q2R_mult).
  pose proof (qmin_le p q). pose proof (qmin_le r s).
  pose proof (qmin_le (qmin p q) (qmin r s)).
  pose proof (qmax_ge p q). pose proof (qmax_ge r s).
  pose proof (qmax_ge (qmax p q) (qmax r s)).
  destruct (between _ _ x y Hx) as [X1 X2].
  destruct (between _ _ y (Q2R a) Hy) as [A1 A2].
  destruct (between _ _ y (Q2R b) Hy) as [B1 B2].
  rewrite (Rmult_comm y (Q2R a)), (Rmult_comm (Q2R c) (Q2R a)), (Rmult_comm (Q2R d) (Q2R a)) in *.
  rewrite (Rmult_comm y (Q2R b)), (Rmult_comm (Q2R c) (Q2R b)), (Rmult_comm (Q2R d) (Q2R b)) in *.
  split; [destruct X1, A1, B1 | destruct X2, A2, B2]; lra.
Qed.

Definition holds_zero (i : interval) : bool :=
  match i with None => true | Some (l, h) => Qle_bool l 0 && Qle_bool 0 h end.

Lemma holds_zero_within i : within i 0 -> holds_zero i = true.
Proof.
  destruct i as [[l h]|]; simpl; auto. intros [L H].
  replace 0 with (Q2R 0) in L, H by (unfold Q2R; simpl; lra).
  apply andb_true_iff; split; apply Qle_bool_iff, Rle_Qle; assumption.
Qed.

(* ---- A ring to compute in ---- *)

Record Ring := {
  C : Type;
  zero : C; one : C;
  add : C -> C -> C; mul : C -> C -> C; opp : C -> C;
  is_zero : C -> bool;
  of_Q : Q -> C;
  to_Q : C -> option Q;  (* of the elements that are seen to be rational *)
  enclose : C -> interval
}.

(* The elements of the ring are real numbers, by v. *)
Record Laws (o : Ring) (v : C o -> R) : Prop := {
  law_zero : v (zero o) = 0;
  law_one : v (one o) = 1;
  law_add : forall a b, v (add o a b) = v a + v b;
  law_mul : forall a b, v (mul o a b) = v a * v b;
  law_opp : forall a, v (opp o a) = - v a;
  law_is_zero : forall a, is_zero o a = true -> v a = 0;
  law_of_Q : forall q, v (of_Q o q) = Q2R q;
  law_to_Q : forall a q, to_Q o a = Some q -> v a = Q2R q;
  law_enclose : forall a, within (enclose o a) (v a)
}.

Definition sign (o : Ring) (a : C o) : option comparison :=
  if is_zero o a then Some Eq
  else match enclose o a with
       | None => None
       | Some (l, h) => if Z.ltb 0 (Qnum l) then Some Gt else if Z.ltb (Qnum h) 0 then Some Lt else None
       end.

Definition has_sign (c : comparison) (x : R) : Prop :=
  match c with Eq => x = 0 | Lt => x < 0 | Gt => 0 < x end.

Lemma sign_sound o v a c : Laws o v -> sign o a = Some c -> has_sign c (v a).
Proof.
  unfold sign. intros L. destruct (is_zero o a) eqn:Z.
  - intros E; injection E; intros; subst. exact (law_is_zero o v L a Z).
  - pose proof (law_enclose o v L a) as W. destruct (enclose o a) as [[l h]|]; [|discriminate].
    simpl in W. unfold Q2R in W.
    assert (0 < / IZR (Zpos (Qden l))) by (apply Rinv_0_lt_compat, IZR_lt; lia).
    assert (0 < / IZR (Zpos (Qden h))) by (apply Rinv_0_lt_compat, IZR_lt; lia).
    destruct (Z.ltb_spec 0 (Qnum l)).
    + intros E; injection E; intros; subst. simpl. apply IZR_lt in H1. nra.
    + destruct (Z.ltb_spec (Qnum h) 0); [|discriminate].
      intros E; injection E; intros; subst. simpl. apply IZR_lt in H2. nra.
Qed.

Fixpoint power (o : Ring) (a : C o) (n : nat) : C o :=
  match n with O => one o | S O => a | S n => mul o a (power o a n) end.

Lemma power_sound o v a n : Laws o v -> v (power o a n) = v a ^ n.
Proof.
  intros L. induction n as [|[|n] IH]; [apply L | simpl; ring |].
  change (power o a (S (S n))) with (mul o a (power o a (S n))).
  rewrite (law_mul o v L), IH. reflexivity.
Qed.

(* A formula, computed. *)
Fixpoint value (o : Ring) (env : list (C o)) (e : expr) : C o :=
  match e with
  | Num z => of_Q o (z # 1)
  | Frac z d => of_Q o (Qred (z # d))
  | Sym i => nth i env (zero o)
  | Add a b => add o (value o env a) (value o env b)
  | Sub a b => add o (value o env a) (opp o (value o env b))
  | Mul a b => mul o (value o env a) (value o env b)
  | Opp a => opp o (value o env a)
  | Pow a n => power o (value o env a) n
  end.

Definition are (o : Ring) (v : C o -> R) (xs : list (C o)) (rs : list R) := map v xs = rs.

Lemma value_sound o v env e : Laws o v -> v (value o env e) = eval (map v env) e.
Proof.
  intros L. induction e; cbn [value eval].
  - rewrite (law_of_Q o v L). unfold Q2R; simpl. lra.
  - rewrite (law_of_Q o v L), (Qeq_eqR _ _ (Qred_correct _)). reflexivity.
  - rewrite <- (law_zero o v L). symmetry. apply map_nth.
  - rewrite (law_add o v L). congruence.
  - rewrite (law_add o v L), (law_opp o v L), IHe1, IHe2. reflexivity.
  - rewrite (law_mul o v L). congruence.
  - rewrite (law_opp o v L). congruence.
  - rewrite (power_sound o v _ _ L). congruence.
Qed.

Fixpoint values (o : Ring) (env : list (C o)) (defs : list expr) : list (C o) :=
  match defs with [] => env | d :: defs => values o (env ++ [value o env d]) defs end.

Lemma values_sound o v : Laws o v -> forall defs env xs,
  defined (map v env) defs xs -> map v (values o env defs) = map v env ++ xs.
Proof.
  intros L. induction defs as [|d defs IH]; intros env [|x xs]; simpl; try contradiction.
  - intros _. symmetry. apply app_nil_r.
  - intros [E D]. rewrite (IH _ xs); rewrite map_app; simpl; rewrite (value_sound o v _ _ L), <- E.
    + rewrite <- app_assoc. reflexivity.
    + exact D.
Qed.

(* ---- The rational numbers ---- *)

Definition whole (a b : Q) : bool := (Pos.eqb (Qden a) 1 && Pos.eqb (Qden b) 1)%bool.
Definition qadd (a b : Q) : Q := if whole a b then (Qnum a + Qnum b) # 1 else Qred (a + b).
Definition qmul (a b : Q) : Q := if whole a b then (Qnum a * Qnum b) # 1 else Qred (a * b).

Definition rationals : Ring := {|
  C := Q; zero := 0%Q; one := 1%Q; add := qadd; mul := qmul; opp := Qopp;
  is_zero := fun q => Z.eqb (Qnum q) 0; of_Q := fun q => q; to_Q := fun q => Some q;
  enclose := fun q => Some (q, q) |}.

Lemma rationals_laws : Laws rationals Q2R.
Proof.
  assert (W : forall a b, whole a b = true -> a = (Qnum a # 1) /\ b = (Qnum b # 1)).
  { intros [n d] [m e] E. apply andb_true_iff in E. destruct E as [D F].
    apply Pos.eqb_eq in D, F. simpl in D, F. subst. auto. }
  constructor; simpl; intros; try (unfold Q2R; simpl; lra).
  - unfold qadd. destruct (whole a b) eqn:E.
    + destruct (W a b E) as [-> ->]; unfold Q2R; simpl. rewrite plus_IZR. field.
    + rewrite (Qeq_eqR _ _ (Qred_correct _)). apply Q2R_plus.
  - unfold qmul. destruct (whole a b) eqn:E.
    + destruct (W a b E) as [-> ->]; unfold Q2R; simpl. rewrite mult_IZR. field.
    + rewrite (Qeq_eqR _ _ (Qred_correct _)). apply Q2R_mult.
  - apply Q2R_opp.
  - apply Z.eqb_eq in H. unfold Q2R. rewrite H. ring.
  - congruence.
Qed.

(* ---- A ring with one more element x: polynomials in x, lowest coefficient first. With a
   modulus f of length n, x^n = f, and the n-th power of x is replaced. ---- *)

Section Extension.
  Variable o : Ring.
  Variable modulus : option (list (C o)).
  Variable known : interval.  (* x lies in it *)

  Definition prepend (a : C o) (l : list (C o)) : list (C o) :=
    match l with [] => if is_zero o a then [] else [a] | _ => a :: l end.

  Fixpoint ladd (a b : list (C o)) {struct a} : list (C o) :=
    match a, b with
    | [], _ => b
    | _, [] => a
    | x :: a, y :: b => prepend (add o x y) (ladd a b)
    end.

  Fixpoint lscale (c : C o) (l : list (C o)) : list (C o) :=
    match l with [] => [] | x :: l => prepend (mul o c x) (lscale c l) end.

  Definition shift (l : list (C o)) : list (C o) :=
    match l with
    | [] => []
    | _ => match modulus with
           | None => zero o :: l
           | Some f =>
               if Nat.eqb (length l) (length f)
               then ladd (fold_right prepend [] (firstn (length f) (zero o :: l)))
                         (lscale (last (zero o :: l) (zero o)) f)
               else zero o :: l
           end
    end.

  Fixpoint lmul (a b : list (C o)) : list (C o) :=
    match a with
    | [] => []
    | x :: a => let rest := shift (lmul a b) in
                if is_zero o x then rest else ladd (lscale x b) rest
    end.

  Definition constant (c : C o) : list (C o) := prepend c [].

  Fixpoint lenclose (l : list (C o)) : interval :=
    match l with
    | [] => Some (0%Q, 0%Q)
    | [c] => enclose o c
    | c :: l => iadd (enclose o c) (imul known (lenclose l))
    end.

  Definition extension : Ring := {|
    C := list (C o); zero := []; one := constant (one o);
    add := ladd; mul := lmul; opp := map (opp o);
    is_zero := forallb (is_zero o);
    of_Q := fun q => constant (of_Q o q);
    to_Q := fun l => match l with [] => Some 0%Q | [c] => to_Q o c | _ => None end;
    enclose := lenclose |}.

  Variable v : C o -> R.
  Variable x : R.
  Hypothesis L : Laws o v.

  Fixpoint lval (l : list (C o)) : R :=
    match l with [] => 0 | c :: l => v c + x * lval l end.

  Hypothesis HM : match modulus with None => True | Some f => x ^ length f = lval f end.
  Hypothesis HK : within known x.

  Lemma prepend_val a l : lval (prepend a l) = v a + x * lval l.
  Proof.
    destruct l; simpl; auto. destruct (is_zero o a) eqn:E; simpl; auto.
    rewrite (law_is_zero o v L a E). ring.
  Qed.

  Lemma ladd_val a : forall b, lval (ladd a b) = lval a + lval b.
  Proof.
    induction a as [|c a IH]; intros [|d b]; simpl; try ring.
    rewrite prepend_val, IH, (law_add o v L). ring.
  Qed.

  Lemma lscale_val c l : lval (lscale c l) = v c * lval l.
  Proof.
    induction l as [|d l IH]; simpl; [ring|]. rewrite prepend_val, IH, (law_mul o v L). ring.
  Qed.

  Lemma trim_val l : lval (fold_right prepend [] l) = lval l.
  Proof. induction l as [|c l IH]; simpl; auto. rewrite prepend_val, IH. reflexivity. Qed.

  Lemma last_val : forall n l, length l = S n ->
    lval l = lval (firstn n l) + x ^ n * v (last l (zero o)).
  Proof.
    induction n as [|n IH]; intros [|c l] E; try discriminate; injection E; intros E'.
    - destruct l; [simpl; ring | discriminate].
    - destruct l as [|d l]; [discriminate|].
      change (last (c :: d :: l) (zero o)) with (last (d :: l) (zero o)).
      change (lval (c :: d :: l)) with (v c + x * lval (d :: l)).
      rewrite (IH (d :: l) E'). simpl firstn. simpl pow.
      change (lval (c :: ?q)) with (v c + x * lval q). simpl. ring.
  Qed.

  Lemma shift_val l : lval (shift l) = x * lval l.
  Proof.
    assert (S0 : lval (zero o :: l) = x * lval l) by (simpl; rewrite (law_zero o v L); ring).
    unfold shift. destruct l as [|c l]; [simpl; ring|]. revert HM.
    destruct modulus as [f|]; intros HF; [|exact S0].
    destruct (Nat.eqb_spec (length (c :: l)) (length f)) as [E|E]; [|exact S0].
    rewrite ladd_val, trim_val, lscale_val, <- HF, <- S0.
    rewrite (last_val (length f) (zero o :: c :: l)) by (simpl length in *; lia). ring.
  Qed.

  Lemma lmul_val a : forall b, lval (lmul a b) = lval a * lval b.
  Proof.
    induction a as [|c a IH]; intros b; simpl; [ring|]. destruct (is_zero o c) eqn:E.
    - rewrite shift_val, IH, (law_is_zero o v L c E). ring.
    - rewrite ladd_val, lscale_val, shift_val, IH. ring.
  Qed.

  Lemma constant_val c : lval (constant c) = v c.
  Proof. unfold constant. rewrite prepend_val. simpl. ring. Qed.

  Lemma lenclose_val l : within (lenclose l) (lval l).
  Proof.
    induction l as [|c [|d l] IH].
    - simpl. unfold Q2R; simpl; lra.
    - simpl. replace (v c + x * 0) with (v c) by ring. apply L.
    - change (within (iadd (enclose o c) (imul known (lenclose (d :: l))))
                     (v c + x * lval (d :: l))).
      apply iadd_within; [apply L | apply imul_within; assumption].
  Qed.

  Lemma extension_laws : Laws extension lval.
  Proof.
    constructor; simpl.
    - reflexivity.
    - rewrite constant_val. apply L.
    - apply ladd_val.
    - apply lmul_val.
    - induction a as [|c a IH]; simpl; [ring|]. rewrite IH, (law_opp o v L). ring.
    - induction a as [|c a IH]; simpl; auto. rewrite andb_true_iff. intros [Z Z'].
      rewrite (law_is_zero o v L c Z), (IH Z'). ring.
    - intros q. rewrite constant_val. apply L.
    - intros [|c [|d l]] q E; try discriminate; simpl.
      + injection E; intros; subst. unfold Q2R; simpl; lra.
      + rewrite (law_to_Q o v L c q E). ring.
    - apply lenclose_val.
  Qed.
End Extension.
