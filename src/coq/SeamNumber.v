(* SPDX-License-Identifier: GPL-3.0-or-later *)

(* Real algebraic numbers, each a root of a polynomial over those before it, and polynomials
   over them. `zero_holds` and `number_holds` turn a computation that ends in `true` into a
   statement about R. *)

From Coq Require Import Reals QArith Qreals List Bool Arith Lia Lra.
Require Import SeamRing.
Import ListNotations.
Local Open Scope R_scope.

(* ---- One generator more ---- *)

(* The polynomial as x^n = f, if its leading coefficient is seen to be rational. *)
Definition modulus (o : Ring) (coefficients : list (C o)) : option (list (C o)) :=
  match to_Q o (last coefficients (zero o)) with
  | Some q =>
      if Z.eqb (Qnum q) 0 then None
      else Some (map (mul o (of_Q o (Qopp (Qinv q)))) (removelast coefficients))
  | None => None
  end.

(* Horner's rule with intervals. *)
Fixpoint horner (coefficients : list interval) (x : interval) : interval :=
  match coefficients with
  | [] => Some (0%Q, 0%Q)
  | c :: rest => iadd c (imul x (horner rest x))
  end.

Definition halves (part : Q * Q) : list (Q * Q) :=
  let (l, h) := part in let m := Qred ((l + h) / 2) in [(l, m); (m, h)].

Fixpoint hull (part : Q * Q) (parts : list (Q * Q)) : interval :=
  match parts with
  | [] => Some part
  | next :: rest => hull (qmin (fst part) (fst next), qmax (snd part) (snd next)) rest
  end.

(* Every part is halved, and those on which the polynomial does not vanish are left out. *)
Definition narrow (coefficients : list interval) (parts : list (Q * Q)) : list (Q * Q) :=
  filter (fun part => holds_zero (horner coefficients (Some part))) (flat_map halves parts).

Fixpoint isolate (rounds : nat) (coefficients : list interval) (parts : list (Q * Q)) : interval :=
  match rounds, parts with
  | _, [] => None
  | O, part :: rest => hull part rest
  | S rounds, _ => isolate rounds coefficients (narrow coefficients parts)
  end.

Definition in_part (x : R) (part : Q * Q) := within (Some part) x.

Lemma horner_within o v cs i x : Laws o v -> within i x ->
  within (horner (map (enclose o) cs) i) (lval o v x cs).
Proof.
  intros L W. induction cs as [|c cs IH]; cbn [map horner lval].
  - simpl. unfold Q2R; simpl; lra.
  - apply iadd_within; [apply L | apply imul_within; assumption].
Qed.

Lemma halves_cover x part : in_part x part -> Exists (in_part x) (halves part).
Proof.
  destruct part as [l h]. unfold halves. set (m := Qred _). intros [A B].
  destruct (Rle_dec x (Q2R m)).
  - apply Exists_cons_hd. split; assumption.
  - apply Exists_cons_tl, Exists_cons_hd. split; [lra | assumption].
Qed.

Lemma hull_within x parts : forall part,
  in_part x part \/ Exists (in_part x) parts -> within (hull part parts) x.
Proof.
  induction parts as [|next rest IH]; intros part H; simpl hull.
  - destruct H as [H|H]; [exact H | inversion H].
  - apply IH. pose proof (qmin_le (fst part) (fst next)). pose proof (qmax_ge (snd part) (snd next)).
    destruct part as [a b], next as [c d]; simpl in *. destruct H as [H|H].
    + left. unfold in_part in *; simpl in *; lra.
    + inversion H; subst.
      * left. unfold in_part in *; simpl in *; lra.
      * right. assumption.
Qed.

Lemma isolate_within o v cs x : Laws o v -> lval o v x cs = 0 -> forall rounds parts,
  Exists (in_part x) parts -> within (isolate rounds (map (enclose o) cs) parts) x.
Proof.
  intros L Z. induction rounds as [|rounds IH]; intros [|part rest] H; try exact I.
  - inversion H; subst; apply hull_within; auto.
  - apply IH. apply Exists_exists in H. destruct H as (p & P & W).
    pose proof (halves_cover _ _ W) as E. apply Exists_exists in E. destruct E as (q & Q & V).
    apply Exists_exists. exists q. split; [|exact V]. apply filter_In. split.
    + apply in_flat_map. exists p. auto.
    + apply holds_zero_within. rewrite <- Z. apply horner_within; assumption.
Qed.

Lemma split_last_val o v x cs : Laws o v -> cs <> [] ->
  lval o v x cs = lval o v x (removelast cs) + x ^ length (removelast cs) * v (last cs (zero o)).
Proof.
  intros L N. destruct cs as [|c cs]; [congruence|].
  pose proof (app_removelast_last (zero o) N) as E.
  assert (D : length (c :: cs) = S (length (removelast (c :: cs)))).
  { rewrite E at 1. rewrite app_length. simpl. lia. }
  rewrite (last_val o v x _ _ D). f_equal. f_equal.
  rewrite E at 2. rewrite firstn_app, Nat.sub_diag, firstn_all. apply app_nil_r.
Qed.

Lemma scaled_val o v x c cs : Laws o v -> lval o v x (map (mul o c) cs) = v c * lval o v x cs.
Proof.
  intros L. induction cs as [|d cs IH]; simpl; [ring|]. rewrite IH, (law_mul o v L). ring.
Qed.

Lemma modulus_sound o v x cs : Laws o v -> lval o v x cs = 0 ->
  match modulus o cs with None => True | Some f => x ^ length f = lval o v x f end.
Proof.
  intros L Z. unfold modulus. destruct (to_Q o (last cs (zero o))) as [q|] eqn:T; [|exact I].
  pose proof (law_to_Q o v L _ _ T) as V. destruct (Z.eqb_spec (Qnum q) 0) as [E|E]; [exact I|].
  destruct cs as [|c cs].
  - exfalso. simpl in V. rewrite (law_zero o v L) in V. apply E.
    unfold Q2R in V. symmetry in V. apply Rmult_integral in V. destruct V as [V|V].
    + apply eq_IZR. exact V.
    + exfalso. revert V. apply Rinv_neq_0_compat. apply not_0_IZR. discriminate.
  - rewrite map_length, scaled_val by assumption. rewrite (law_of_Q o v L).
    rewrite split_last_val in Z by (assumption || discriminate).
    rewrite V in Z. rewrite Q2R_opp, Q2R_inv.
    + assert (Q2R q <> 0).
      { intros F. apply E. unfold Q2R in F. apply Rmult_integral in F. destruct F as [F|F].
        - apply eq_IZR. exact F.
        - exfalso. revert F. apply Rinv_neq_0_compat, not_0_IZR. discriminate. }
      set (n := length (removelast (c :: cs))) in *. set (r := lval o v x (removelast (c :: cs))) in *.
      apply (Rmult_eq_reg_r (Q2R q)); [|assumption]. field_simplify; [|assumption]. lra.
    + intros F. apply E. unfold Qeq in F. simpl in F. lia.
Qed.

(* ---- Towers ---- *)

(* The number g with low <= g <= high at which the polynomial, a formula in the generators
   before it and itself, is 0. *)
Record generator := Generator { polynomial : expr; low : expr; high : expr }.

(* Both lists begin with the last one. *)
Fixpoint roots (gs : list generator) (xs : list R) : Prop :=
  match gs, xs with
  | [], [] => True
  | g :: gs, x :: xs =>
      roots gs xs /\ eval [] (low g) <= x <= eval [] (high g) /\
      eval (rev xs ++ [x]) (polynomial g) = 0
  | _, _ => False
  end.

Record Tower := { ring : Ring; symbols : list (C ring) }.

Definition rational (e : expr) : Q := value rationals [] e.

Fixpoint tower (rounds : nat) (gs : list generator) : Tower :=
  match gs with
  | [] => {| ring := rationals; symbols := [] |}
  | g :: gs =>
      let t := tower rounds gs in
      let o := ring t in
      let old := map (constant o) (symbols t) in
      let cs := value (extension o None None) (old ++ [[zero o; one o]]) (polynomial g) in
      let m := modulus o cs in
      let known := isolate rounds (map (enclose o) cs) [(rational (low g), rational (high g))] in
      {| ring := extension o m known; symbols := old ++ [shift o m (constant o (one o))] |}
  end.

Lemma tower_sound rounds gs : forall xs, roots gs xs ->
  exists v, Laws (ring (tower rounds gs)) v /\ map v (symbols (tower rounds gs)) = rev xs.
Proof.
  induction gs as [|g gs IH]; intros [|x xs]; simpl roots; try contradiction.
  - intros _. exists Q2R. split; [exact rationals_laws | reflexivity].
  - intros (H & B & Z). destruct (IH xs H) as (v & L & S). cbn [tower].
    set (t := tower rounds gs) in *. set (o := ring t) in *.
    set (old := map (constant o) (symbols t)).
    set (cs := value (extension o None None) (old ++ [[zero o; one o]]) (polynomial g)).
    assert (P : lval o v x cs = 0).
    { rewrite <- Z. unfold cs.
      rewrite (value_sound (extension o None None) (lval o v x) _ _ (extension_laws o None None v x L I I)).
      f_equal. rewrite map_app. unfold old. rewrite map_map.
      erewrite map_ext; [|intros a; apply constant_val; exact L].
      fold o in S. rewrite S. f_equal. simpl. f_equal.
      rewrite (law_zero o v L), (law_one o v L). ring. }
    pose proof (modulus_sound o v x cs L P) as M.
    assert (K : within (isolate rounds (map (enclose o) cs)
                          [(rational (low g), rational (high g))]) x).
    { apply (isolate_within o v cs x L P). apply Exists_cons_hd. unfold in_part; simpl.
      unfold rational. rewrite !(value_sound _ _ _ _ rationals_laws). exact B. }
    set (known := isolate rounds _ _) in *. exists (lval o v x). split.
    + exact (extension_laws o (modulus o cs) known v x L M K).
    + cbn [symbols ring]. rewrite map_app. unfold old. rewrite map_map.
      erewrite map_ext; [|intros a; apply constant_val; exact L].
      fold o in S. rewrite S. cbn [rev map]. f_equal. f_equal.
      rewrite (shift_val o (modulus o cs) v x L M), constant_val by exact L.
      rewrite (law_one o v L). ring.
Qed.

(* ---- Polynomials in the variables numbered 0 to n - 1; the last is the outermost ---- *)

Fixpoint polynomials (o : Ring) (n : nat) : Ring :=
  match n with O => o | S n => extension (polynomials o n) None None end.

Fixpoint number (o : Ring) (n : nat) : C o -> C (polynomials o n) :=
  match n with O => fun c => c | S n => fun c => constant (polynomials o n) (number o n c) end.

Fixpoint variable (o : Ring) (n k : nat) : C (polynomials o n) :=
  match n with
  | O => zero o
  | S n => if Nat.eqb k n then [zero (polynomials o n); one (polynomials o n)]
           else constant (polynomials o n) (variable o n k)
  end.

Fixpoint pval (o : Ring) (v : C o -> R) (x : nat -> R) (n : nat) : C (polynomials o n) -> R :=
  match n with O => v | S n => lval (polynomials o n) (pval o v x n) (x n) end.

Lemma polynomials_laws o v x n : Laws o v -> Laws (polynomials o n) (pval o v x n).
Proof. intros L. induction n; [exact L | apply extension_laws; auto; exact I]. Qed.

Lemma number_val o v x n c : Laws o v -> pval o v x n (number o n c) = v c.
Proof.
  intros L. induction n; [reflexivity|]. simpl. rewrite constant_val; [assumption|].
  apply polynomials_laws; assumption.
Qed.

Lemma variable_val o v x n k : Laws o v -> (k < n)%nat -> pval o v x n (variable o n k) = x k.
Proof.
  intros L. induction n as [|n IH]; intros K; [lia|]. pose proof (polynomials_laws o v x n L) as P.
  simpl. destruct (Nat.eqb_spec k n) as [->|N].
  - simpl. rewrite (law_zero _ _ P), (law_one _ _ P). ring.
  - rewrite constant_val by exact P. apply IH. lia.
Qed.

(* Multiplication by a variable, and by a number. *)
Fixpoint times_variable (o : Ring) (n k : nat) : C (polynomials o n) -> C (polynomials o n) :=
  match n with
  | O => fun c => c
  | S n => fun l => if Nat.eqb k n
                    then match l with [] => [] | _ => zero (polynomials o n) :: l end
                    else map (times_variable o n k) l
  end.

Fixpoint scaled (o : Ring) (n : nat) (c : C o) : C (polynomials o n) -> C (polynomials o n) :=
  match n with O => mul o c | S n => map (scaled o n c) end.

Lemma times_variable_val o v x n k p : Laws o v -> (k < n)%nat ->
  pval o v x n (times_variable o n k p) = x k * pval o v x n p.
Proof.
  intros L. induction n as [|n IH]; intros K; [lia|]. pose proof (polynomials_laws o v x n L) as P.
  simpl. destruct (Nat.eqb_spec k n) as [->|N].
  - destruct p; simpl; [ring|]. rewrite (law_zero _ _ P). ring.
  - induction p as [|c p IHp]; simpl; [ring|]. rewrite IHp, IH by lia. ring.
Qed.

Lemma scaled_number_val o v x n c p : Laws o v ->
  pval o v x n (scaled o n c p) = v c * pval o v x n p.
Proof.
  intros L. induction n as [|n IH]; simpl; [apply (law_mul o v L)|].
  induction p as [|d p IHp]; simpl; [ring|]. rewrite IHp, IH. ring.
Qed.

Definition at_list (xs : list R) (k : nat) : R := nth k xs 0.

(* Generators, then variables. *)
Definition start (t : Tower) (n : nat) : list (C (polynomials (ring t) n)) :=
  map (number (ring t) n) (symbols t) ++ map (variable (ring t) n) (seq 0 n).

Lemma start_val t v xs gens : Laws (ring t) v -> map v (symbols t) = gens ->
  map (pval (ring t) v (at_list xs) (length xs)) (start t (length xs)) = gens ++ xs.
Proof.
  intros L <-. unfold start. rewrite map_app, !map_map. f_equal.
  - apply map_ext. intros c. apply number_val. exact L.
  - transitivity (map (at_list xs) (seq 0 (length xs))).
    + apply map_ext_in. intros k K. apply in_seq in K. apply variable_val; [exact L | lia].
    + apply nth_ext with (d := 0) (d' := 0).
      * rewrite map_length, seq_length. reflexivity.
      * intros k K. rewrite map_length, seq_length in K.
        rewrite nth_indep with (d' := at_list xs 0) by (rewrite map_length, seq_length; exact K).
        rewrite map_nth, seq_nth by exact K. reflexivity.
Qed.

(* A formula in generators, variables and named values. *)
Definition computed (t : Tower) (n : nat) (defs : list expr) (goal : expr) :=
  value (polynomials (ring t) n) (values (polynomials (ring t) n) (start t n) defs) goal.

Lemma computed_val t v xs defs named goal gens : Laws (ring t) v -> map v (symbols t) = gens ->
  defined (gens ++ xs) defs named ->
  pval (ring t) v (at_list xs) (length xs) (computed t (length xs) defs goal) =
  eval ((gens ++ xs) ++ named) goal.
Proof.
  intros L S D. pose proof (polynomials_laws _ v (at_list xs) (length xs) L) as P.
  unfold computed. rewrite (value_sound _ _ _ _ P).
  rewrite (values_sound _ _ P defs _ named); rewrite (start_val t v xs gens L S);
    [reflexivity | exact D].
Qed.

(* ---- What the theorems of zero and of the sign of one number say ---- *)

Inductive relation := Positive | Nonnegative | Zero | Nonzero | Nonpositive | Negative.

Definition holds (r : relation) (x : R) : Prop :=
  match r with
  | Positive => x > 0 | Nonnegative => x >= 0 | Zero => x = 0
  | Nonzero => x <> 0 | Nonpositive => x <= 0 | Negative => x < 0
  end.

Definition allows (r : relation) (c : comparison) : bool :=
  match r, c with
  | Positive, Gt | Nonnegative, (Gt | Eq) | Zero, Eq | Nonzero, (Gt | Lt)
  | Nonpositive, (Lt | Eq) | Negative, Lt => true
  | _, _ => false
  end.

Lemma allows_sound r c x : has_sign c x -> allows r c = true -> holds r x.
Proof. destruct r, c; simpl; intros; try discriminate; lra. Qed.

Lemma allows_not r c x : has_sign c x -> allows r c = false -> ~ holds r x.
Proof. destruct r, c; simpl; intros; try discriminate; lra. Qed.

Definition zero_check (rounds : nat) (gs : list generator) (n : nat) (defs : list expr)
  (goal : expr) : bool :=
  let t := tower rounds gs in
  is_zero (polynomials (ring t) n) (computed t n defs goal).

Theorem zero_holds gs gens xs defs named goal :
  roots gs gens -> defined (rev gens ++ xs) defs named -> forall rounds,
  zero_check rounds gs (length xs) defs goal = true ->
  eval ((rev gens ++ xs) ++ named) goal = 0.
Proof.
  intros G D rounds Z. destruct (tower_sound rounds gs gens G) as (v & L & S).
  rewrite <- (computed_val _ v xs defs named goal _ L S D).
  apply (law_is_zero _ _ (polynomials_laws _ v (at_list xs) (length xs) L)). exact Z.
Qed.

(* The number that a polynomial without variables is. *)
Fixpoint no_variable (o : Ring) (n : nat) : C (polynomials o n) -> option (C o) :=
  match n with
  | O => fun c => Some c
  | S n => fun l => match l with
                    | [] => Some (zero o) | [c] => no_variable o n c | _ => None
                    end
  end.

Lemma no_variable_val o v x n p c : Laws o v -> no_variable o n p = Some c -> pval o v x n p = v c.
Proof.
  intros L. induction n as [|n IH]; simpl; [congruence|].
  destruct p as [|q [|? ?]]; simpl; try discriminate.
  - intros E. injection E; intros; subst. symmetry. apply L.
  - intros E. rewrite (IH q E). ring.
Qed.

Definition number_check (rounds : nat) (gs : list generator) (n : nat) (defs : list expr)
  (goal : expr) : option comparison :=
  let t := tower rounds gs in
  match no_variable (ring t) n (computed t n defs goal) with
  | Some c => sign (ring t) c
  | None => None
  end.

Theorem number_sign rounds gs gens xs defs named goal c :
  roots gs gens -> defined (rev gens ++ xs) defs named ->
  number_check rounds gs (length xs) defs goal = Some c ->
  has_sign c (eval ((rev gens ++ xs) ++ named) goal).
Proof.
  intros G D E. destruct (tower_sound rounds gs gens G) as (v & L & S).
  rewrite <- (computed_val _ v xs defs named goal _ L S D).
  unfold number_check in E. destruct (no_variable _ _ _) as [a|] eqn:N; [|discriminate].
  rewrite (no_variable_val _ v _ _ _ a L N). exact (sign_sound _ _ _ _ L E).
Qed.

Definition number_holds_check rounds gs n defs goal r : bool :=
  match number_check rounds gs n defs goal with Some c => allows r c | None => false end.

Theorem number_holds r gs gens xs defs named goal :
  roots gs gens -> defined (rev gens ++ xs) defs named -> forall rounds,
  number_holds_check rounds gs (length xs) defs goal r = true ->
  holds r (eval ((rev gens ++ xs) ++ named) goal).
Proof.
  intros G D rounds E. unfold number_holds_check in E.
  destruct (number_check _ _ _ _ _) as [c|] eqn:N; [|discriminate].
  exact (allows_sound r c _ (number_sign _ _ _ _ _ _ _ _ G D N) E).
Qed.

Definition number_fails_check rounds gs n defs goal r : bool :=
  match number_check rounds gs n defs goal with Some c => negb (allows r c) | None => false end.

Theorem number_fails r gs gens xs defs named goal :
  roots gs gens -> defined (rev gens ++ xs) defs named -> forall rounds,
  number_fails_check rounds gs (length xs) defs goal r = true ->
  ~ holds r (eval ((rev gens ++ xs) ++ named) goal).
Proof.
  intros G D rounds E. unfold number_fails_check in E.
  destruct (number_check _ _ _ _ _) as [c|] eqn:N; [|discriminate]. apply negb_true_iff in E.
  exact (allows_not r c _ (number_sign _ _ _ _ _ _ _ _ G D N) E).
Qed.

(* Generators to about 6 digits, else to 30, else to 120: the next where a sign is not seen. *)
Definition rounds_that_do (check : nat -> bool) : option nat :=
  if check 20%nat then Some 20%nat
  else if check 100%nat then Some 100%nat
  else if check 400%nat then Some 400%nat else None.

Lemma by_rounds (check : nat -> bool) (P : Prop) :
  (forall rounds, check rounds = true -> P) ->
  (match rounds_that_do check with Some _ => true | None => false end) = true -> P.
Proof.
  unfold rounds_that_do. intros H.
  destruct (check 20%nat) eqn:A; [intros _; exact (H _ A)|].
  destruct (check 100%nat) eqn:B; [intros _; exact (H _ B)|].
  destruct (check 400%nat) eqn:D; [intros _; exact (H _ D)|discriminate].
Qed.

(* The kernel computes when the theorem is closed. *)
Ltac compute_by theorem :=
  refine (by_rounds _ _ theorem _); vm_cast_no_check (eq_refl true).

(* An identity needs no enclosures. *)
Ltac compute_exactly_by theorem :=
  refine (theorem 0%nat _); vm_cast_no_check (eq_refl true).

(* ---- Inequalities as differences ---- *)

Lemma le_of x y : y - x >= 0 -> x <= y. Proof. lra. Qed.
Lemma lt_of x y : y - x > 0 -> x < y. Proof. lra. Qed.
